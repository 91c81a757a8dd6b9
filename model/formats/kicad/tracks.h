#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Draws (segment …) or (arc …), and its opening in the mask where it lists a mask layer.
void drawTrack(Canvas& canvas, const Item& track);

}  // namespace model::kicad
