#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// Fills Layer::opposite: on which layer of a panel the elements of a card's layer lie when the card is flipped.
/// Counted from the outside, the first copper layer becomes the last, and so do the dielectrics between them; a mask,
/// paste, silk or component layer becomes the one of its type on the other side that is as many rows away from the
/// board; drills become those that span the mirrored layers. Layers that find no such partner keep none: their mirror
/// image lies on no layer of the board. `layers` come in document order with sides and spans set.
void setOpposites(std::vector<Layer>& layers);

}  // namespace model
