#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// What is drilled into the hole of a pad or via once more (KiCad 10): (backdrill (size 0.6) (layers "B.Cu" "In2.Cu")),
/// from an outer layer to the last one that is cut, and (tertiary_drill …) the same from the other side.
void drawBackDrills(Canvas& canvas, const Item& item, const Origin& origin, PointD at);

}  // namespace model::kicad
