#pragma once

#include "model/geometry/shapes.h"

namespace model {

/// The length of an edge, in nm: straight, or on the circle around the node's centre, of the mean of the two radii.
[[nodiscard]] double pathLength(const PathNode& from, Point to);

}  // namespace model
