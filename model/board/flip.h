#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// Fills Layer::opposite: on which layer of a panel the elements of a card's layer lie when the card is flipped.
/// Counted from the outside, the first copper layer becomes the last, and so do the dielectrics between them; a mask,
/// paste, silk or component layer becomes the one of its type on the other side that is as many rows away from the
/// board; drills become those that span the mirrored layers. Layers that find no such partner keep none: their mirror
/// image lies on no layer of the board. So does the copper of a board that has one layer of it: flipped, that lies
/// on the other side. `layers` come in document order with sides and spans set.
void setOpposites(std::vector<Layer>& layers);

/// The same of synthetic layers, once those of the job have theirs: solder masks follow the layers of their openings,
/// bodies of components the side and what they stand on. Parts of the substrate are paired from the outside if all of
/// them begin and end at the same copper once the board is flipped: not where blind holes are on one side only.
void setSyntheticOpposites(std::vector<Layer>& layers);

}  // namespace model
