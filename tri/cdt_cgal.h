#pragma once

#include <vector>

#include "tri/triangulate.h"

namespace tri {

/// The independent triangulator: CGAL's constrained Delaunay triangulation and a walk over its faces that counts
/// windings. CGAL breaks ties between points on one circle in its own way; a final pass of flips makes the result the
/// unique one. Never names the edges of a crossing. Contours that cancel only along part of an edge still count as
/// obstacles: a third contour that crosses one there is Crossing here and fine elsewhere.
[[nodiscard]] Status triangulateCgal(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

}  // namespace tri
