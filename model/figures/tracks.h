#pragma once

#include "model/board/document.h"

namespace model {

/// Calls `visit(node, end, width, innerWidth)` for each edge that a round pen draws of an element, from a node to the
/// next point: one of a line or an arc, those of a trail; a disc or ring is a dot. Areas have none.
template <class Visit>
void forEachTrack(const Document& document, ElementId element, Visit visit) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            return visit(PathNode{line.a, {}, EdgeKind::Line}, line.b, line.width, line.innerWidth);
        }
        case ElementKind::Arc: {
            const ArcGeometry& arc = document.arcs[row];
            return visit(arc.node, arc.end, arc.width, arc.innerWidth);
        }
        case ElementKind::Circle: {
            const CircleGeometry& circle = document.circles[row];
            const PathNode dot{circle.centre, {}, EdgeKind::Line};
            return visit(dot, circle.centre, circle.diameter, circle.innerDiameter);
        }
        case ElementKind::Trail: {
            const TrailGeometry& trail = document.trails[row];
            const std::span<const PathNode> nodes = document.nodesOf(trail);
            const std::span<const Nm> widths = document.widthsOf(trail);
            for (std::size_t i = 0; i < widths.size(); ++i) {
                visit(nodes[i], nodes[i + 1].point, widths[i], trail.innerWidth);
            }
            return;
        }
        case ElementKind::Area: return;
    }
}

}  // namespace model
