#pragma once

#include <vector>

#include "tri/triangulate.h"

namespace tri {

/// The sequential triangulator: Delaunay triangulation by insertion, missing contours by corridors, erasing by corners.
/// About 0.3 µs per vertex and 80 bytes per vertex of working memory, which the thread keeps (up to 64 MB).
[[nodiscard]] Status triangulateCpu(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

/// One polygon over all cores. The vertices of a round of the insertion order lie along a Hilbert curve; the curve is
/// cut into parts, and so is the mesh. Every part inserts its own vertices at the same time as the others and changes
/// nothing but its own triangles; what would reach across a border is taken back and inserted afterwards, which are few
/// (a part of n vertices has a border of about sqrt(n)). There are no locks, and because the triangulation is unique,
/// the result depends neither on the cut nor on the number of threads.
[[nodiscard]] Status triangulateParallel(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

}  // namespace tri
