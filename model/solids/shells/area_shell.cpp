#include "model/solids/shells/area_shell.h"

namespace model {

namespace {

void addEdge(EdgeLoops& loops, const PathNodes& nodes, std::size_t i) {
    const PathNode& node = nodes[i];
    switch (node.edge) {
        case EdgeKind::Line: return loops.addLine(toDouble(node.point), toDouble(nodes.endOf(i)));
        case EdgeKind::Curve: return loops.addCurve(nodes.curveAt(i));
        case EdgeKind::ArcClockwise:
        case EdgeKind::ArcCounterClockwise:
            return loops.addArc(toDouble(node.point), toDouble(nodes.endOf(i)), toDouble(node.centre),
                                node.edge == EdgeKind::ArcClockwise);
    }
}

bool isCircle(const PathNodes& nodes) {
    return nodes.size() == 1 && nodes.front().edge != EdgeKind::Line && nodes.front().edge != EdgeKind::Curve;
}

bool addContour(EdgeLoops& loops, const PathNodes& nodes) {
    if (isCircle(nodes)) {
        const Edge circle = edgeOf(nodes.front(), nodes.front().point);
        const std::size_t before = loops.loopCount();
        loops.addCircle(circle.centre, circle.radius);
        return loops.loopCount() > before;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        addEdge(loops, nodes, i);
    }
    return loops.endLoop();
}

}  // namespace

std::vector<EdgeLoops> areaOutlines(const ShapeTable& shapes, ShapeId shape) {
    std::vector<EdgeLoops> regions;
    bool hasIsland = false;
    for (const Contour& contour : shapes.contoursOf(shape)) {
        if (!contour.isHole) {
            EdgeLoops island;
            hasIsland = addContour(island, shapes.nodesOf(contour));
            if (hasIsland) {
                regions.push_back(std::move(island));
            }
        } else if (hasIsland) {
            addContour(regions.back(), shapes.nodesOf(contour));
        }
    }
    return regions;
}

}  // namespace model
