#pragma once

#include "model/geometry/discretise.h"

namespace model {

/// What the polygons cover, as unite() has it, but in time that does not grow with the square of their number: those
/// whose boxes meet are united, group by group. Groups of more than `atOnce` polygons are united in parts, which then
/// still overlap; 0: however many they are.
[[nodiscard]] PolygonSet uniteNear(const PolygonSet& set, std::size_t atOnce = 0);

}  // namespace model
