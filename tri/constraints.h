#pragma once

#include "tri/contours.h"
#include "tri/mesh.h"
#include "tri/threads.h"
#include "tri/triangulate.h"

namespace tri {

/// Turns a Delaunay triangulation of a polygon's vertices in a box into the one constrained by its contours: every
/// contour is made of edges, all other edges are locally Delaunay. Nearly all contour edges of a board are there
/// already; a missing one replaces the triangles it crosses. A contour edge that runs through vertices is split there
/// (`contours` afterwards has the pieces). Crossing if two contour edges cross or lie on each other in one direction;
/// the mesh is of no further use then. `scratch` and `vertexScratch` are overwritten.
[[nodiscard]] Status insertContours(Mesh& mesh, Contours& contours, Cores cores, Scratch<std::uint8_t>& scratch,
                                    Scratch<std::uint32_t>& vertexScratch);

}  // namespace tri
