#pragma once

#include <vector>

#include "model/geometry/discretise.h"
#include "model/solids/shells/shell.h"

namespace model {

/// The regions of a shape in its own coordinates, one per island with the holes that follow it; lines stay lines and
/// arcs stay arcs. Contours without area are left out.
[[nodiscard]] std::vector<EdgeLoops> areaOutlines(const ShapeTable& shapes, ShapeId shape);

}  // namespace model
