#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/geometry/shapes.h"

namespace model::kicad {

/// A line or arc of an outline.
struct ChainEdge {
    PathNode from;
    Point to;
};

struct Chains {
    std::vector<std::vector<PathNode>> loops;  ///< closed, in no sense of winding
    std::vector<std::size_t> open;             ///< edges that are part of no loop
    std::size_t repeated = 0;                  ///< edges that are drawn again; they count once and are not open
    double widestJoint = 0.0;                  ///< between ends that were joined, nm
};

/// Joins edges in any order and direction to loops, ends within `tolerance` nm of each other. Edges with equal ends are
/// loops if they are whole circles, and nothing otherwise; edges that lead nowhere are left out, and those that are
/// drawn again between the same ends.
[[nodiscard]] Chains chained(std::span<const ChainEdge> edges, double tolerance);

/// Edges that hang together, without those that lead nowhere and lines that are drawn again, each group a drawing of
/// its own; ends within `tolerance` nm of each other are moved to one point. Edges that only cross or end beside
/// another one's ends do not hang together.
[[nodiscard]] std::vector<std::vector<ChainEdge>> drawings(std::span<const ChainEdge> edges, double tolerance);

/// Loops as a shape: those within an even number of others are islands, the rest holes.
[[nodiscard]] ShapeSketch nested(std::span<const std::vector<PathNode>> loops);

}  // namespace model::kicad
