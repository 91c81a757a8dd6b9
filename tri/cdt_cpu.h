#pragma once

#include <vector>

#include "tri/triangulate.h"

namespace tri {

/// The sequential triangulator: Delaunay triangulation by insertion, missing contours by corridors, erasing by corners.
/// About 0.3 µs per vertex and 80 bytes per vertex of working memory, which the thread keeps (up to 64 MB).
[[nodiscard]] Status triangulateCpu(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

}  // namespace tri
