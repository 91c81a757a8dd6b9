#include "model/odb/region.h"

#include "model/document_builder.h"

namespace model::odb {

PolygonSet polygonsOf(const ShapeSketch& sketch, const Discretisation& how) {
    DocumentBuilder scratch;
    const ShapeId shape = scratch.addShape(sketch);
    return discretise(scratch.shapes(), shape, how);
}

ShapeSketch sketchOf(const PolygonSet& polygons) {
    ShapeSketch sketch;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            sketch.addPolygon(polygons.loop(polygon.firstLoop + i), i > 0);
        }
    }
    return sketch;
}

bool isIdentity(const Placement& placement) {
    return placement.origin == Point{} && placement.clockwiseDeg == 0.0 && !placement.isMirrored;
}

PathNode placed(const PathNode& node, const Placement& placement) {
    PathNode moved = node;
    moved.point = placement.apply(node.point);
    if (node.edge != EdgeKind::Line) {
        moved.centre = placement.apply(node.centre);
        const bool isClockwise = (node.edge == EdgeKind::ArcClockwise) != placement.isMirrored;
        moved.edge = isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
    }
    return moved;
}

ShapeSketch sketchOf(const ShapeTable& table, std::uint32_t shape, const Placement& placement) {
    ShapeSketch sketch;
    const bool isMoved = !isIdentity(placement);
    for (const Contour& contour : table.contoursOf(ShapeId{shape})) {
        sketch.beginContour(contour.isHole);
        for (const PathNode& node : table.nodesOf(contour)) {
            sketch.addNode(isMoved ? placed(node, placement) : node);
        }
    }
    return sketch;
}

ShapeSketch placed(const ShapeSketch& sketch, const Placement& placement) {
    ShapeSketch moved;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        moved.beginContour(sketch.isHole(i));
        for (const PathNode& node : sketch.contour(i)) {
            moved.addNode(placed(node, placement));
        }
    }
    return moved;
}

}  // namespace model::odb
