#pragma once

#include "model/formats/kicad/canvas.h"

namespace model::kicad {

/// Joins openings of the solder mask where less than `leastWeb` of mask would be left between them
/// (solder_mask_min_width), as KiCad does when it plots: what is nearer than half of it to openings on all sides is
/// opened too. When all else is drawn.
void joinMaskOpenings(Canvas& canvas, double leastWeb);

}  // namespace model::kicad
