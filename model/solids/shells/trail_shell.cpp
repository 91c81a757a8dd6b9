#include "model/solids/shells/trail_shell.h"

#include <algorithm>
#include <iterator>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_union.h"
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

/// A trail in pieces that are plain, so that there is little to unite.
class Pieces {
public:
    explicit Pieces(const Drawn& drawn) : m_drawn(drawn), m_middles(middlesOf(drawn)) {}

    /// Adds a row of tracks, split where it is not plain. False when a track could not be united with itself.
    bool add(std::size_t first, std::size_t count) {
        if (isClosed(first, count)) {
            if (std::optional<EdgeLoops> ring = offsetRing(std::span(m_middles).subspan(first, count))) {
                m_regions.push_back(std::move(*ring));
                return true;
            }
        }
        while (count > 1) {
            std::size_t split = 1;
            if (!m_middles.empty()) {
                Offset offset = offsetOutline(std::span(m_middles).subspan(first, count));
                if (offset.outline) {
                    m_regions.push_back(std::move(*offset.outline));
                    return true;
                }
                split = std::clamp<std::size_t>(offset.brokenAt, 1, count - 1);
            }
            if (!add(first, split)) {
                return false;
            }
            first += split;
            count -= split;
        }
        return count == 0 || addTrack(first);
    }
    [[nodiscard]] const Regions& regions() const { return m_regions; }

private:
    [[nodiscard]] bool isClosed(std::size_t first, std::size_t count) const {
        return count > 1 && !m_middles.empty() && m_middles[first].a == m_middles[first + count - 1].b;
    }

    bool addTrack(std::size_t track) {
        const PathNode& node = m_drawn.nodes[track];
        const Point next = m_drawn.nodes[track + 1].point;
        if (node.edge == EdgeKind::Line) {
            m_regions.push_back(lineOutline({node.point, next, m_drawn.widthOf(track), 0}, false));
            return true;
        }
        std::optional<Regions> arc = arcOutlines({node, next, m_drawn.widthOf(track), 0});
        if (arc) {
            std::ranges::move(*arc, std::back_inserter(m_regions));
        }
        return arc.has_value();
    }

    const Drawn& m_drawn;
    std::vector<Edge> m_middles;
    Regions m_regions;
};

std::optional<Regions> regionsOf(const Drawn& drawn) {
    Pieces pieces(drawn);
    return pieces.add(0, drawn.widths.size()) ? unite(pieces.regions()) : std::nullopt;
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
