#pragma once

#include <optional>

#include "model/board/document.h"

namespace model::formats {

/// The first copy (row of Document::instances) of which what it clears around it on a negative layer
/// (Layer::clearedAround) lies over copper of another copy, or of copies on that one; nothing if there is none. Copper
/// that both have along a common edge is none: its width is what booleans round.
[[nodiscard]] std::optional<std::size_t> firstClearingNeighbours(const Document& board, LayerId layer);

}  // namespace model::formats
