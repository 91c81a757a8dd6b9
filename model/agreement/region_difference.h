#pragma once

#include <optional>

#include "model/geometry/discretise.h"

namespace model {

/// How two regions differ, counted on a grid of square pixels. What only one of them covers counts once a pixel is
/// taken away all around it, so that rounding and chords, which make slivers along edges, do not.
struct RegionDifference {
    double areas[2]{};        ///< of either region, nm²
    double only[2]{};         ///< what only the first, and only the second, covers beyond a pixel from its edge, nm²
    Box box;                  ///< around that; empty if they do not differ
    std::optional<Point> at;  ///< a location in it: of the lowest the leftmost

    /// Of the larger region.
    [[nodiscard]] double share() const;
};

/// `pixel` is above 0. Polygons of a set may overlap: a point is inside when any of them covers it. Parallel.
[[nodiscard]] RegionDifference differenceOf(const PolygonSet& a, const PolygonSet& b, Nm pixel);

}  // namespace model
