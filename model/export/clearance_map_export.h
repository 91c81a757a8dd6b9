#pragma once

#include <string>

#include "model/clearance/clearance_map.h"

namespace model {

/// A map as a table: a row for every cell that lies between nets within the map's reach, from the lower left one, with
/// the location of its middle, the spacing there and the two nets, the nearer one first. Lengths in nanometres. `map`
/// is that of MapDetail::Nets over a layer of `board`, whose copies it names by their row of StepTree::copies; 0 is the
/// board itself.
[[nodiscard]] std::string clearanceMapCsv(const Document& board, LayerId layer, const ClearanceMap& map);

}  // namespace model
