#pragma once

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// The region without those corners between lines that lie within `tolerance` nm of the line that replaces them. What
/// clips pours on a grid leaves such corners in dozens: pairs a few nanometres apart, and points along straight edges.
/// The first corner of each loop stays, and so do all ends of arcs. Where the new outline would touch itself, and where
/// the region has curves, it stays as it is.
[[nodiscard]] EdgeLoops withoutNeedlessCorners(const EdgeLoops& region, double tolerance);

}  // namespace model
