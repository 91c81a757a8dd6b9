#pragma once

#include <map>

#include "model/index/board_index.h"
#include "model/section/intervals.h"

namespace model {

/// Where along a straight line the layers are that have outlines of their own (rigid-flex: Layer::profile). All other
/// layers are all along and have no entry. Steps beside such ones (the frame of a panel) have none of the films that
/// are laid on a board.
using LayerRanges = std::map<LayerId, Intervals>;

/// Between two locations of a board, in nm from `a`; copies of steps have the layers that their steps say.
[[nodiscard]] LayerRanges layerRangesOf(const BoardIndex& index, PointD a, PointD b);

}  // namespace model
