#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/texts.h"

namespace model::kicad {

/// (barcode (at x y angle) (layer …) (size w h) (text …) (text_height h) (type qr) (ecc_level L) (hide …) (knockout …)
/// (margins x y)) of KiCad 10, as one region. Its place is the board's in footprints too. The symbol fills the size
/// around the place, its text stands 1 mm below it; knockouts are a box without both, wider by the margins or by a
/// tenth of the smaller size. On the back all of it is mirrored. A text that cannot be encoded is reported, and nothing
/// is drawn, as in KiCad.
void drawBarcode(Canvas& canvas, const Item& barcode, const Variables& variables, const Origin& origin);

}  // namespace model::kicad
