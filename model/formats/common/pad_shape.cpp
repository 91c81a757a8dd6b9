#include "model/formats/common/pad_shape.h"

#include "model/geometry/outlines.h"

namespace model::formats {

ShapeSketch outlineOf(const PadShape& shape) {
    ShapeSketch sketch;
    switch (shape.kind) {
        case PadShape::Kind::Nothing: break;
        case PadShape::Kind::Round: addDisc(sketch, shape.width, false); break;
        case PadShape::Kind::Ring:
            addDisc(sketch, shape.width, false);
            addDisc(sketch, shape.height, true);
            break;
        case PadShape::Kind::Oval: addOval(sketch, shape.width, shape.height, false); break;
        case PadShape::Kind::Region: return shape.region;
    }
    return sketch;
}

}  // namespace model::formats
