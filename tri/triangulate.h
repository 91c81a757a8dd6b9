#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/point.h"

/// Polygons with holes in, triangles out. Knows nothing of boards.
namespace tri {

using base::Point;

/// One polygon: loop i is points[loopStart[i] .. loopStart[i + 1]), `loopStart` has one entry more than there are
/// loops. The first loop is the outline, the others are holes; the outline winds counter-clockwise, holes clockwise.
/// Loops are not closed by a repeated point. Loops may touch themselves and each other at points and along edges (a
/// keyhole bridge is two opposite edges, which cancel), but not cross.
struct Polygon {
    std::span<const Point> points;
    std::span<const std::uint32_t> loopStart;
};

enum class Outcome : std::uint8_t {
    Ok,          ///< the triangles cover the polygon exactly (checked: their area is its area)
    Degenerate,  ///< no area: no triangles
    Crossing,    ///< edges cross or regions overlap: no triangles; repair with integer booleans and try again
};

/// Constrained Delaunay triangulation of one polygon by CGAL, then erasing of what lies outside (paper,
/// "Non-procedural"). `triangles` gets three indices into `polygon.points` per triangle, counter-clockwise. Nothing is
/// appended unless the outcome is Ok. Exact: every coordinate is an integer of at most 2^30, no point is moved or
/// added. Thread-safe on different outputs.
[[nodiscard]] Outcome triangulate(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

}  // namespace tri
