#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Draws what a zone fills as KiCad has stored it. Up to KiCad 6 a fill may be stored as the middle of what it is, half
/// the zone's minimum width inside; it is grown then. Zones that are not filled are reported, and so are rule areas,
/// which draw nothing.
void drawZone(Canvas& canvas, const Item& zone);

}  // namespace model::kicad
