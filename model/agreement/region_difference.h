#pragma once

#include <vector>

#include "model/geometry/discretise.h"

namespace model {

/// How two regions differ, counted on a grid of square pixels. What only one of them covers counts once a pixel is
/// taken away all around it, so that rounding and chords, which make slivers along edges, do not.
struct RegionDifference {
    /// What differs in one place; any two are more than 64 pixels apart.
    struct Place {
        Box box;           ///< around what differs
        Point at;          ///< a location in that: of the lowest the leftmost
        double only[2]{};  ///< its share of RegionDifference::only
    };

    double areas[2]{};  ///< of either region, nm²
    double only[2]{};   ///< what only the first, and only the second, covers beyond a pixel from its edge, nm²
    Box box;            ///< around that; empty if they do not differ
    std::vector<Place> places{};  ///< the largest first

    /// Of the larger region.
    [[nodiscard]] double share() const;
};

/// `pixel` is above 0. Polygons of a set may overlap: a point is inside when any of them covers it. Parallel.
[[nodiscard]] RegionDifference differenceOf(const PolygonSet& a, const PolygonSet& b, Nm pixel);

}  // namespace model
