#pragma once

#include <vector>

#include "model/index/board_index.h"

namespace model {

/// The pads that plated holes join to a pad, itself among them: one piece of copper, with a pad on each layer that has
/// one. Pads and holes are of one copy and one net, and touch. Rising by id; only the element itself where it is no pad
/// of copper, or no such hole touches it.
[[nodiscard]] std::vector<BoardElement> joinedPads(const BoardIndex& index, BoardElement pad);

}  // namespace model
