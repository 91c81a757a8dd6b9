#include "model/geometry/region.h"

#include "model/geometry/nesting.h"

namespace model {

PolygonSet polygonsOf(const ShapeSketch& sketch, const Discretisation& how) {
    ShapeTable table;
    const ShapeId shape = table.add(nestHoles(sketch));
    return discretise(table, shape, how);
}

ShapeSketch sketchOf(const ShapeTable& table, ShapeId shape, const Placement& placement) {
    ShapeSketch sketch;
    sketch.append(table, shape, placement);
    return sketch;
}

}  // namespace model
