#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "model/base/point.h"
#include "tri/verify.h"

namespace tri {

/// A border edge from one point to another, with the inside on its left.
using BorderEdge = std::pair<base::Point, base::Point>;

/// Sweeps a line over border edges and lone points. Overlap if two edges cross or touch anywhere but at common ends, or
/// if the inside is not on the left of every edge; MissingVertex if a lone point lies inside or on an edge.
[[nodiscard]] Fault sweep(std::span<const BorderEdge> border, std::span<const base::Point> lonePoints);

}  // namespace tri
