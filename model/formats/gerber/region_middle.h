#pragma once

#include "model/geometry/shapes.h"

namespace model::gerber {

/// Where a pad lies that a file draws as a region and not as a flash: the middle of the smallest rectangle around it,
/// one of whose sides runs along an edge of its convex hull. For rectangles, their rounded and chamfered forms, ovals
/// and symmetrical trapezoids that is the pad's own middle, however it is rotated. Shapes without such an axis, and
/// those whose hull has more than 500 corners, lie in the middle of the box around them. 0, 0 for an empty region.
[[nodiscard]] Point middleOfPad(const ShapeSketch& region);

}  // namespace model::gerber
