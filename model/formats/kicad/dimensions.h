#pragma once

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/texts.h"

namespace model::kicad {

/// (dimension …) of the board, or of a footprint, where it is written as on the board: its text, and its lines. KiCad
/// up to 5 stores them; later versions store two points and a style, from which they follow:
///   - aligned, orthogonal: the line between both points moved aside by the height, broken where the text is, with
///     arrows at its ends and extension lines that begin at an offset from the points;
///   - leader: an arrow at the first point, a line to the second one and on to the text, which may have a frame;
///   - radial: a cross at the centre, an arrow at the circle and a line outwards, then to the text;
///   - center: a cross.
void drawDimension(Canvas& canvas, const Item& dimension, const Variables& variables);

}  // namespace model::kicad
