#include "model/board/board_heights.h"

namespace model {

namespace {

/// The lowest and the highest copper layer; nullptr without copper.
struct OuterCopper {
    const Layer* bottom = nullptr;
    const Layer* top = nullptr;

    [[nodiscard]] bool isSingle() const { return bottom == top; }
};

OuterCopper outermost(const Document& document) {
    OuterCopper outer;
    for (const Layer& layer : document.layers) {
        if (layer.isBoardCopper()) {
            outer.bottom = outer.bottom == nullptr || layer.z < outer.bottom->z ? &layer : outer.bottom;
            outer.top = outer.top == nullptr || layer.z > outer.top->z ? &layer : outer.top;
        }
    }
    return outer;
}

Nm upperFace(const Layer& layer) {
    return layer.z + layer.thickness;
}

}  // namespace

ZRange boardHeights(const Document& document) {
    const OuterCopper outer = outermost(document);
    if (outer.bottom == nullptr) {
        return {0, document.boardThickness};
    }
    const ZRange copper{outer.bottom->z, upperFace(*outer.top)};
    if (!outer.isSingle()) {
        return copper;
    }
    return outer.bottom->side == LayerSide::Bottom ? ZRange{copper.bottom, copper.top + document.boardThickness}
                                                   : ZRange{copper.bottom - document.boardThickness, copper.top};
}

ZRange substrateHeights(const Document& document) {
    const OuterCopper outer = outermost(document);
    if (outer.bottom == nullptr) {
        return {0, document.boardThickness};
    }
    if (!outer.isSingle()) {
        return {upperFace(*outer.bottom), outer.top->z};
    }
    const Nm bottom =
        outer.bottom->side == LayerSide::Bottom ? upperFace(*outer.bottom) : outer.bottom->z - document.boardThickness;
    return {bottom, bottom + document.boardThickness};
}

}  // namespace model
