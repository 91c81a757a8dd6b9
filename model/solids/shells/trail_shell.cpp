#include "model/solids/shells/trail_shell.h"

#include <algorithm>
#include <iterator>

#include "model/geometry/edge_faults.h"
#include "model/geometry/edge_union.h"
#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/line_shell.h"
#include "model/solids/shells/trail_offset.h"

namespace model {

namespace {

using Regions = std::vector<EdgeLoops>;

/// A trail that is drawn with other widths: its own, or that of its drill.
struct Drawn {
    std::span<const PathNode> nodes;
    std::span<const Nm> widths;
    Nm oneWidth = 0;  ///< for all tracks, instead of `widths`

    [[nodiscard]] Nm widthOf(std::size_t track) const { return oneWidth > 0 ? oneWidth : widths[track]; }
};

/// The middles of the tracks with their pens. Empty where an arc is not one true circle, or a track is a dot.
std::vector<Edge> middlesOf(const Drawn& drawn) {
    EdgeLoops path;
    path.edges.reserve(drawn.widths.size());
    for (std::size_t i = 0; i < drawn.widths.size(); ++i) {
        const PathNode& node = drawn.nodes[i];
        const PointD next = toDouble(drawn.nodes[i + 1].point);
        if (node.edge == EdgeKind::Line) {
            path.addLine(toDouble(node.point), next);
        } else {
            path.addArc(toDouble(node.point), next, toDouble(node.centre), node.edge == EdgeKind::ArcClockwise);
        }
        if (path.edges.size() != i + 1 || drawn.widthOf(i) <= 0) {
            return {};
        }
        path.edges.back().pen = drawn.widthOf(i) / 2.0;
    }
    return std::move(path.edges);
}

/// No value when one of them could not be united with itself.
std::optional<Regions> tracksOf(const Drawn& drawn) {
    Regions tracks;
    for (std::size_t i = 0; i < drawn.widths.size(); ++i) {
        const PathNode& node = drawn.nodes[i];
        const Point next = drawn.nodes[i + 1].point;
        if (node.edge == EdgeKind::Line) {
            tracks.push_back(lineOutline({node.point, next, drawn.widthOf(i), 0}, false));
            continue;
        }
        std::optional<Regions> arc = arcOutlines({node, next, drawn.widthOf(i), 0});
        if (!arc) {
            return std::nullopt;
        }
        std::ranges::move(*arc, std::back_inserter(tracks));
    }
    return tracks;
}

std::optional<Regions> regionsOf(const Drawn& drawn) {
    if (std::optional<EdgeLoops> outline = offsetOutline(middlesOf(drawn))) {
        return Regions{std::move(*outline)};
    }
    const std::optional<Regions> tracks = tracksOf(drawn);
    return tracks ? unite(*tracks) : std::nullopt;
}

/// The outline of the drill as a hole in that of the pen, where both are plain.
std::optional<EdgeLoops> slotOf(const Regions& outer, const Regions& inner) {
    if (outer.size() != 1 || inner.size() != 1 || outer.front().loopCount() != 1 || inner.front().loopCount() != 1) {
        return std::nullopt;
    }
    EdgeLoops slot = outer.front();
    std::ranges::copy(inner.front().edges, std::back_inserter(slot.edges));
    slot.endLoop();
    return findFault(slot) ? std::nullopt : std::optional(std::move(slot));
}

}  // namespace

std::optional<std::vector<EdgeLoops>> trailOutlines(const Document& document, const TrailGeometry& trail) {
    const Drawn drawn{document.nodesOf(trail), document.widthsOf(trail), 0};
    std::optional<Regions> outer = regionsOf(drawn);
    if (!outer || trail.innerWidth <= 0) {
        return outer;
    }
    const std::optional<Regions> inner = regionsOf({drawn.nodes, drawn.widths, trail.innerWidth});
    if (!inner) {
        return std::nullopt;
    }
    std::optional<EdgeLoops> slot = slotOf(*outer, *inner);
    return slot ? std::optional(Regions{std::move(*slot)}) : subtract(*outer, *inner);
}

std::vector<EdgeLoops> trackOutlines(const Document& document, const TrailGeometry& trail) {
    const std::span<const PathNode> nodes = document.nodesOf(trail);
    const std::span<const Nm> widths = document.widthsOf(trail);
    std::vector<EdgeLoops> tracks;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const Point next = nodes[i + 1].point;
        std::optional<EdgeLoops> outline = nodes[i].edge == EdgeKind::Line
                                               ? lineOutline({nodes[i].point, next, widths[i], trail.innerWidth}, false)
                                               : arcOutline({nodes[i], next, widths[i], trail.innerWidth});
        if (outline && outline->loopCount() > 0) {
            tracks.push_back(std::move(*outline));
        }
    }
    return tracks;
}

}  // namespace model
