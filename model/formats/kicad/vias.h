#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/unused_pads.h"

namespace model::kicad {

/// (via …): its copper, its hole from layer to layer and its back-drills, and openings of the solder mask where it is
/// not tented. Only what is called blind, buried or a microvia ends on the layers it names.
void drawVia(Canvas& canvas, UnusedPads& unused, const Item& via);

/// What else protects the holes of a via, or in the setup those of all (KiCad 10), is reported: (capping yes), (filling
/// yes), (covering (front yes) (back no)), (plugging …). It changes nothing of what is drawn.
void reportProtection(Canvas& canvas, const Item& item);

/// Does a pad or via keep copper only where something ends there?
[[nodiscard]] bool removesUnused(const Item& item);
/// And does it keep that on its outermost layers in any case? Only where the file says so: KiCad 6 and 7 do not write
/// what is not so.
[[nodiscard]] bool keepsEnds(const Item& item);

}  // namespace model::kicad
