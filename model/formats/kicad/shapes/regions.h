#pragma once

#include <span>
#include <vector>

#include "model/geometry/loops/edge_loops.h"
#include "model/geometry/shapes.h"

/// Regions with exact lines and arcs, as pads, openings and zones need them. Lengths in nanometres.
namespace model::kicad {

/// A closed contour as a region. Nothing for less than an area.
[[nodiscard]] std::vector<EdgeLoops> regionsOf(const PathNodes& contour);
/// What a round pen covers along an edge; equal ends of an arc are a full circle, of a line a dot.
[[nodiscard]] std::vector<EdgeLoops> penAlong(const PathNode& from, Point to, double width);
/// All of them as one sketch, islands followed by their holes. Straight-edged within 1 µm where they cannot be united
/// exactly.
[[nodiscard]] ShapeSketch united(std::span<const EdgeLoops> regions);
/// The first without the second ones.
[[nodiscard]] ShapeSketch without(std::span<const EdgeLoops> from, std::span<const EdgeLoops> what);
/// Everything within `margin` of the sketch, with round corners; a negative margin takes as much away from its inside.
[[nodiscard]] ShapeSketch grown(const ShapeSketch& sketch, double margin);

}  // namespace model::kicad
