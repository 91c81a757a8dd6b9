#pragma once

#include <vector>

#include "model/board/document.h"
#include "model/clearance/ring_width.h"

namespace model {

/// What is left of a pad around a plated hole on one layer.
struct AnnularRing {
    ElementId hole;
    ElementId pad;  ///< the element that leaves most of itself around the hole; none if there is none
    RingWidth ring;
};

/// A ring of every plated hole and slot, with a net or without, that passes the copper layer after back-drilling: that
/// of the one element that leaves most around it, pads, tracks and planes alike, so copper made of several elements may
/// leave more than is said. Copper of another net does not count; copper without a net does, and around a hole without
/// a net any copper. A pad that the hole breaks out of counts before one that the drill removes, that one before tracks
/// and planes that the hole cuts into. Widths from `below` (nm) on may be infinite. By hole, rising; holes without a
/// size are left out. Over all cores, the same with any number of threads.
[[nodiscard]] std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below);

}  // namespace model
