#include "ui/views/seen_face.h"

#include <algorithm>
#include <optional>

#include "model/board/document.h"

namespace ui {

float seenFace(const BoardView& view, const model::Document& board) {
    const std::vector<render::ZRange> heights = view.drawnHeights();
    const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
    std::optional<float> face;
    for (std::size_t row = 0; row < std::min(heights.size(), board.layers.size()); ++row) {
        if (board.layers[row].isCopper()) {
            const float height = isFromBelow ? heights[row].z0 : heights[row].z1;
            face = !face ? height : isFromBelow ? std::min(*face, height) : std::max(*face, height);
        }
    }
    return face.value_or(0.0F);
}

}  // namespace ui
