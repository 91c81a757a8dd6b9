#include "model/export/drawings/drawn_outlines.h"

#include <cmath>

#include "model/geometry/discretise.h"
#include "model/geometry/edges.h"
#include "model/solids/shells/arc_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/line_shell.h"

namespace model {

namespace {

constexpr std::string_view kNoWidth = "it has no width";

Point halfWay(const ArcGeometry& arc) {
    const Edge middle = edgeOf(arc.node, arc.end);
    const PointD p = pointAt(middle, lengthOf(middle) / 2);
    return {static_cast<Nm>(std::lround(p.x)), static_cast<Nm>(std::lround(p.y))};
}

void add(EdgeLoops region, std::vector<EdgeLoops>& regions) {
    if (region.loopCount() > 0) {
        regions.push_back(std::move(region));
    }
}

void addArc(const ArcGeometry& arc, std::vector<EdgeLoops>& regions) {
    if (std::optional<EdgeLoops> whole = arcOutline(arc)) {
        return add(std::move(*whole), regions);
    }
    const Point middle = halfWay(arc);
    const PathNode second{middle, arc.node.centre, arc.node.edge};
    for (const ArcGeometry& half : {ArcGeometry{arc.node, middle, arc.width}, {second, arc.end, arc.width}}) {
        if (std::optional<EdgeLoops> outline = arcOutline(half)) {
            add(std::move(*outline), regions);
        }
    }
}

std::vector<EdgeLoops> trailRegions(const Document& document, const TrailGeometry& trail) {
    const std::span<const PathNode> nodes = document.nodesOf(trail);
    const std::span<const Nm> widths = document.widthsOf(trail);
    std::vector<EdgeLoops> regions;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const Point next = nodes[i + 1].point;
        if (nodes[i].edge == EdgeKind::Line) {
            add(lineOutline({nodes[i].point, next, widths[i]}, false), regions);
        } else {
            addArc({nodes[i], next, widths[i]}, regions);
        }
    }
    return regions;
}

CircleGeometry drawnCircle(CircleGeometry circle, bool isHole) {
    if (isHole) {
        circle.innerDiameter = 0;
    }
    return circle;
}

}  // namespace

ElementOutlines drawnOutlinesOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    ElementOutlines drawn;
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Area: return outlinesOf(document, element);
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            add(lineOutline({line.a, line.b, line.width}, (flags & kSquarePen) != 0), drawn.regions);
            break;
        }
        case ElementKind::Arc: {
            const ArcGeometry& arc = document.arcs[row];
            addArc({arc.node, arc.end, arc.width}, drawn.regions);
            break;
        }
        case ElementKind::Circle:
            add(circleOutline(drawnCircle(document.circles[row], (flags & kHole) != 0)), drawn.regions);
            break;
        case ElementKind::Trail: drawn.regions = trailRegions(document, document.trails[row]); break;
    }
    drawn.problem = drawn.regions.empty() ? kNoWidth : std::string_view{};
    return drawn;
}

}  // namespace model
