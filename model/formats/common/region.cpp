#include "model/formats/common/region.h"

#include "model/board/document_builder.h"

namespace model::odb {

PolygonSet polygonsOf(const ShapeSketch& sketch, const Discretisation& how) {
    DocumentBuilder scratch;
    const ShapeId shape = scratch.addShape(sketch);
    return discretise(scratch.shapes(), shape, how);
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
