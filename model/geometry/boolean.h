#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/discretise.h"

namespace model {

/// Integer booleans of polygon sets (polyclipping). Operands may overlap, touch and cross themselves: a point is inside
/// a set when any of its polygons covers it. The result's polygons do not cross or overlap; islands inside holes are
/// polygons of their own.
[[nodiscard]] PolygonSet unite(const PolygonSet& set);

/// Loops that are not sorted into polygons: counter-clockwise around what they cover, clockwise around holes. Loop i is
/// points[loopStart[i] .. loopStart[i + 1]).
struct LoopSet {
    std::vector<Point> points;
    std::vector<std::uint32_t> loopStart{0};
};
/// As unite(), for large sets: its time goes into telling which hole is whose. Loops may touch each other and
/// themselves at points.
[[nodiscard]] LoopSet unitedLoops(const LoopSet& set);

[[nodiscard]] PolygonSet subtract(const PolygonSet& from, const PolygonSet& what);
[[nodiscard]] PolygonSet intersect(const PolygonSet& a, const PolygonSet& b);

/// Every polygon with its outline moved outwards by `distance` nm (inwards when negative), corners mitred; holes stay
/// as they are.
[[nodiscard]] PolygonSet grow(const PolygonSet& set, double distance);

}  // namespace model
