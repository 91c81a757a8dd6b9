#pragma once

#include <optional>

#include "model/board/document.h"
#include "render/modelling/board_frame.h"
#include "render/scene/explosion.h"

namespace ui {

/// The part of the board that a message is about, in the renderer's millimetres; nothing for messages about files or
/// the whole board.
[[nodiscard]] std::optional<render::Box3> locationOf(const model::Diagnostic& message, const model::Document& document,
                                                     const render::BoardFrame& frame);

}  // namespace ui
