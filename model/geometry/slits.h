#pragma once

#include <optional>

#include "model/geometry/shapes.h"

namespace model {

/// The same region without slits. Some programs (KiCad among them) write a region with openings as one contour that
/// runs in to each opening along a straight edge and back along the same edge. Such edges, which a contour runs along
/// both ways, are taken out; what is left of the contour are closed loops, and those that wind against it are holes.
/// No point is moved or made, and exactly the same points are covered: pairs of edges are all that goes. A contour
/// that only touches itself stays whole. An edge counts as run both ways if both its ends are the same, to the
/// nanometre; arcs never do. None if there is nothing to heal, which is found out in one pass over the nodes.
[[nodiscard]] std::optional<ShapeSketch> healSlits(const ShapeSketch& sketch);

}  // namespace model
