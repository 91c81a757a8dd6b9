#pragma once

#include <optional>
#include <vector>

#include "model/geometry/shapes.h"

namespace model {

/// The same region without slits. Some programs (KiCad among them) write a region with openings as one contour that
/// runs in to each opening along a straight edge and back along the same edge. Such edges, which a contour runs along
/// both ways, are taken out; what is left of the contour are closed loops, and those that wind against it are holes.
/// No point is moved or made, and exactly the same points are covered: pairs of edges are all that goes. A contour
/// that only touches itself stays whole. An edge counts as run both ways if both its ends are the same, to the
/// nanometre; arcs never do. None if there is nothing to heal, which is found out in one pass over the nodes.
[[nodiscard]] std::optional<ShapeSketch> healSlits(const ShapeSketch& sketch);

/// For contours that run in along one edge and back along several, past the corners of
/// openings: the closed contour with nodes more where a straight edge is run back along from or to a point on it, so
/// that the way back has the same ends. Only nodes of the contour are repeated, where they lie exactly on the edge. A
/// contour of which a great many edges lie upon each other stays as it is.
[[nodiscard]] std::vector<PathNode> withNodesWhereRunBack(std::vector<PathNode> contour);

/// For contours that run in to an opening along an edge, around it in the direction of the outside, and back along the
/// edge, as DipTrace writes letters: the same contour with such openings run around against the outside, as those of
/// other programs are. By winding alone they would be covered twice, but nobody runs in to draw what is covered
/// already. Openings of straight edges only, from which no other slit leads on; the contour may begin elsewhere.
[[nodiscard]] std::vector<PathNode> withOpeningsAgainst(std::vector<PathNode> contour);

}  // namespace model
