#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Counterbores and countersinks of the hole of a pad or via (KiCad 10):
/// (front_post_machining counterbore (size 1.2) (depth 0.3)), (back_post_machining countersink (size 1.4) (angle 90)).
/// Depths count from the outer copper's surface; a countersink without one ends where the cone has the hole's diameter.
/// Layers of holes pass from copper to copper, so each copper layer that the tool reaches gets a drill, from the
/// outside to there, as wide as the tool is in it; that the rest of its depth is not drawn is reported. `drill` is the
/// hole's diameter, 0 that of a slot, which is reported.
void drawPostMachining(Canvas& canvas, const Item& item, const Origin& origin, PointD at, double drill);

}  // namespace model::kicad
