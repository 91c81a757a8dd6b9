#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Draws what a zone fills as KiCad has stored it. Up to KiCad 6 a fill may be stored as the middle of what it is, half
/// the zone's minimum width inside; it is grown then. Zones that are not filled are reported, and so are rule areas,
/// which draw nothing.
void drawZone(Canvas& canvas, const Item& zone);

/// When all zones are drawn. KiCad stores nothing for a zone whose fill is empty, and says (fill yes): that is a note.
/// Where no zone at all has copper, the fills were never made or were left out of the file.
void reportEmptyFills(Canvas& canvas);

}  // namespace model::kicad
