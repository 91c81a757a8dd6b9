#pragma once

#include "render/modelling/board_model.h"

namespace render {

/// Triangles, or walls, of a piece.
inline constexpr std::uint32_t kPieceSize = 256;

/// Cuts large shapes into pieces that can be left out one by one: their triangles and their walls in Morton order, in
/// runs of kPieceSize, each run a row of BoardModel::shapes with instances and batches of its own. Small shapes stay
/// one piece. Vertices that start a wall come first in their shape. What is drawn stays the same.
void cutIntoPieces(BoardModel& model);

}  // namespace render
