#pragma once

#include "model/figures/figures.h"

namespace model {

/// How deep two figures lie in each other: the smallest distance by which one would have to move in the plane, in
/// whatever direction, so that they have no more than edges in common. 0 when they only touch. Nanometres.
struct Overlap {
    double depth = 0.0;
    bool isExact = true;  ///< else `depth` is a lower bound: they are at least so deep in each other
};

/// Of two figures that touch or overlap at `shared`, a point both cover. Exact (to 1e-3 nm; rounded rectangles, whose
/// corners are rounded to whole nanometres, to 1.5 nm) when both are convex: dots, straight tracks, discs, convex
/// polygons and rounded ones. For two dots that is the sum of the radii less the distance of the centres. Otherwise the
/// deepest pair of discs is reported that was found, one in each figure. Whether the depth is 0 is right for all.
[[nodiscard]] Overlap overlapBetween(const FigureTable& a, std::size_t rowA, const FigureTable& b, std::size_t rowB,
                                     PointD shared);

}  // namespace model
