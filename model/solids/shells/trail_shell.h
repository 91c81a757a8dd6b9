#pragma once

#include <optional>
#include <vector>

#include "model/solids/shells/shell.h"

namespace model {

/// The regions of a trail: one, as long as its tracks join. With an inner width, that of the pen without that of the
/// drill. Without a value when the tracks could not be united; then there are only trackOutlines().
[[nodiscard]] std::optional<std::vector<EdgeLoops>> trailOutlines(const Document& document, const TrailGeometry& trail);
/// The regions of the tracks of a trail, by track. They overlap where tracks join.
[[nodiscard]] std::vector<EdgeLoops> trackOutlines(const Document& document, const TrailGeometry& trail);

}  // namespace model
