#pragma once

#include <vector>

#include "model/geometry/boolean.h"

namespace model {

/// What the polygons cover, as unite() has it, but in time that does not grow with the square of their number: those
/// whose boxes meet are united, group by group. Groups of more than `atOnce` polygons are united in parts, which then
/// still overlap; 0: however many they are.
[[nodiscard]] std::vector<LoopSet> uniteNear(const PolygonSet& set, std::size_t atOnce = 0);

/// The loops of one polygon of a set.
[[nodiscard]] LoopSet loopsOf(const PolygonSet& set, std::size_t row);

}  // namespace model
