#include "model/body.h"

#include <algorithm>

#include "model/copy_outlines.h"
#include "model/geometry/boolean.h"

namespace model {

namespace {

struct Heights {
    Nm bottom = 0;
    Nm top = 0;
};

Heights bodyHeights(const std::vector<Layer>& layers, Nm boardThickness) {
    const Layer* lowest = nullptr;
    const Layer* highest = nullptr;
    for (const Layer& layer : layers) {
        if (!layer.isCopper()) {
            continue;
        }
        lowest = lowest == nullptr || layer.z < lowest->z ? &layer : lowest;
        highest = highest == nullptr || layer.z > highest->z ? &layer : highest;
    }
    if (lowest == nullptr) {
        return {0, boardThickness};
    }
    if (lowest == highest) {
        return {highest->z - boardThickness, highest->z};
    }
    return {lowest->z + lowest->thickness, highest->z};
}

PolygonSet holesThrough(const Document& document, Heights heights, const Discretisation& how) {
    PolygonSet holes;
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        const Layer& layer = document.layer(document.elements.layer[row]);
        const bool isThrough = layer.z <= heights.bottom && layer.z + layer.thickness >= heights.top;
        if ((document.elements.flags[row] & kHole) != 0 && isThrough) {
            holes.append(discretise(document, ElementId{row}, how));
        }
    }
    return holes;
}

ShapeSketch sketchOf(const PolygonSet& set) {
    ShapeSketch sketch;
    for (const PolygonSet::Polygon& polygon : set.polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            sketch.addPolygon(set.loop(polygon.firstLoop + i), i > 0);
        }
    }
    return sketch;
}

}  // namespace

void addBody(DocumentBuilder& builder) {
    const Document& document = builder.soFar();
    if (!document.profile.isValid()) {
        return;
    }
    const Heights heights = bodyHeights(document.layers, document.boardThickness);
    const Discretisation how;
    const PolygonSet outline = withoutCopies(document, discretise(document.shapes, document.profile, how), how);
    const PolygonSet body = subtract(outline, holesThrough(document, heights, how));
    const ShapeSketch sketch = sketchOf(body);
    if (sketch.isEmpty() || heights.top <= heights.bottom) {
        return;
    }
    Layer layer;
    layer.name = "board";
    layer.type = LayerType::Body;
    layer.side = LayerSide::Through;
    layer.isSynthetic = true;
    layer.z = heights.bottom;
    layer.thickness = heights.top - heights.bottom;
    layer.thicknessSource = Source::Derived;
    builder.beginLayer(builder.addLayer(layer));
    builder.addArea({builder.addShape(sketch), {}}, {});
}

void placeBody(std::vector<Layer>& layers, Nm boardThickness) {
    const Heights heights = bodyHeights(layers, boardThickness);
    for (Layer& layer : layers) {
        if (layer.type == LayerType::Body) {
            layer.z = heights.bottom;
            layer.thickness = std::max(heights.top - heights.bottom, 0);
        }
    }
}

}  // namespace model
