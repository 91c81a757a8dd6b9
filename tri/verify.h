#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "tri/triangulate.h"

namespace tri {

/// What a set of triangles can do wrong.
enum class Fault : std::uint8_t {
    None,
    BadIndex,             ///< no point of the polygon, or not the lowest index at its position
    NotCounterClockwise,  ///< clockwise or flat
    WrongArea,            ///< the areas do not add up to the polygon's
    WrongBorder,          ///< the border of the triangles is not the contours
    Overlap,              ///< some location is covered twice, or the contours cross
    MissingVertex,        ///< a point of the polygon inside is no corner
    NotDelaunay,          ///< an edge between two triangles that the perturbed circle test would flip
};

[[nodiscard]] std::string_view nameOf(Fault fault);

/// Checks a result from nothing but the input, in exact integers, sharing only the predicates with the triangulators.
/// `Fault::None` proves that the triangles are the unique triangulation of triangulate.h, all of it:
///  - their border, as a sum of directed edges, is the sum of the contours, so that every location is covered as often
///  as
///    contours wind around it;
///  - a sweep over the border finds no crossing and the inside always on the left, so that this is once or never;
///  - the sweep finds no point inside that is not a corner;
///  - every edge is a contour or locally Delaunay under the perturbation.
/// O(n log n); meant for tests and benchmarks.
[[nodiscard]] Fault verify(const Polygon& polygon, std::span<const std::uint32_t> triangles);

}  // namespace tri
