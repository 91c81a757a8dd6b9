#pragma once

#include <span>

#include "model/formats/kicad/shapes/chains.h"

namespace model::kicad {

/// Pairs of edges of a drawing that share a range of x.
inline constexpr std::size_t kMostSideBySide = 50'000;

/// The outline of a body that a layer draws, in whatever order and direction its edges come: the outer boundary of what
/// the edges of a drawing enclose, of several drawings (chains.h) the one with the largest box. A tab or a plug that
/// shares corners with the body is part of it; lines within it, leads whose lines end on its side, and marks beside it
/// are not. Empty where nothing is enclosed. Of a tangle, more than kMostSideBySide pairs of edges one above the other,
/// a loop is taken as chained() finds it: where all cross all, the pieces are too many.
[[nodiscard]] ShapeSketch largestOutline(std::span<const ChainEdge> edges, double tolerance);

}  // namespace model::kicad
