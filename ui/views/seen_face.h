#pragma once

#include "ui/views/board_view.h"

namespace model {
struct Document;
}

namespace ui {

/// Where the face of the board that the view sees lies as drawn, in mm: the outer side of the copper nearest to the
/// viewer; 0 of a board without copper.
[[nodiscard]] float seenFace(const BoardView& view, const model::Document& board);

}  // namespace ui
