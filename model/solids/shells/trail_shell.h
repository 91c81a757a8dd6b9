#pragma once

#include <vector>

#include "model/solids/shells/shell.h"

namespace model {

/// The regions of the tracks of a trail, one each. They overlap where tracks join.
[[nodiscard]] std::vector<EdgeLoops> trackOutlines(const Document& document, const TrailGeometry& trail);

}  // namespace model
