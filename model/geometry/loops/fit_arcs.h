#pragma once

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// The region with arcs instead of runs of chords, as programs write the arcs of their pours: four corners or more that
/// lie within 50 nm on one circle. The new outline is nowhere further than `tolerance` nm from the old one; where it
/// would touch itself, and where it has curves, the region stays as it is. Circles that are nothing but chords become
/// loops of one edge.
[[nodiscard]] EdgeLoops withFittedArcs(const EdgeLoops& region, double tolerance);

}  // namespace model
