#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/texts.h"

namespace model::kicad {

/// (gr_text_box …), (fp_text_box …): a text that is broken to lines within its box, at the edges of which it is
/// anchored, less the margins; and the border of the box. `frame` is the footprint's.
void drawTextBox(Canvas& canvas, const Item& box, const Frame& frame, const Variables& variables, const Origin& origin);

/// (table …): the texts of its cells, which are boxes, with the lines around it, under its header and between rows and
/// columns. Cells that others span draw nothing.
void drawTable(Canvas& canvas, const Item& table, const Frame& frame, const Variables& variables, const Origin& origin);

}  // namespace model::kicad
