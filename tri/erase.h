#pragma once

#include <cstdint>
#include <vector>

#include "tri/contours.h"
#include "tri/mesh.h"
#include "tri/threads.h"
#include "tri/triangulate.h"

namespace tri {

/// Triangle erasing: appends the triangles inside the contours as indices into the polygon's points. Every contour is
/// an edge of the mesh. No triangle crosses a contour, so looking along one edge from one corner says on which side
/// the whole triangle lies: constant time, no flooding, no point-in-polygon test, and every triangle for itself.
///
/// Proves its result: the triangles that stay border on erased ones exactly along the contours, each on the left. So
/// they cover what the contours surround once, and nothing else. Crossing if that cannot be (a region within a region,
/// a contour that winds the wrong way), Degenerate if nothing stays. `scratch` is overwritten.
[[nodiscard]] Status eraseOutside(const Mesh& mesh, const Contours& contours, Cores cores,
                                  Scratch<std::uint8_t>& scratch, std::vector<std::uint32_t>& triangles);

}  // namespace tri
