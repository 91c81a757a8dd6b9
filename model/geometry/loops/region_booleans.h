#pragma once

#include <span>
#include <vector>

#include "model/geometry/discretise.h"
#include "model/geometry/loops/edge_loops.h"

namespace model {

/// Regions of a boolean that has a result in any case.
struct RegionBoolean {
    std::vector<EdgeLoops> regions;
    bool isExact = true;  ///< as edge_union.h; else straight-edged within 1 µm

    /// Takes another one's beside them; exact as long as both are.
    void append(RegionBoolean other);
};
[[nodiscard]] RegionBoolean unionOf(std::span<const EdgeLoops> regions);
[[nodiscard]] RegionBoolean differenceOf(std::span<const EdgeLoops> from, std::span<const EdgeLoops> what);

/// Islands of a sketch, each with the holes behind it, exact. Islands without area are left out with their holes; of
/// NURBS curves the chords are taken.
[[nodiscard]] std::vector<EdgeLoops> regionsOf(const ShapeSketch& sketch);
/// Regions as contours with corners on the grid of 1 nm, each outline before its holes. Lines stay lines and arcs stay
/// arcs; of NURBS curves the arcs are taken.
[[nodiscard]] ShapeSketch sketchOf(std::span<const EdgeLoops> regions);
/// The same with chords within 1 µm: a polygon for each region.
[[nodiscard]] PolygonSet polygonsOf(std::span<const EdgeLoops> regions);
/// Polygons as regions; those without area are left out.
[[nodiscard]] std::vector<EdgeLoops> regionsOf(const PolygonSet& polygons);

}  // namespace model
