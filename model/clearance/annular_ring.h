#pragma once

#include <span>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/ring_width.h"

namespace model {

/// What is left of a pad around a plated hole on one layer.
struct AnnularRing {
    ElementId hole;
    ElementId pad;  ///< the element that leaves most of itself around the hole; none if there is none
    RingWidth ring;
    bool isOfPads = false;  ///< else of other copper, as the layer has no pad there
};

/// A ring of every plated hole and slot, with a net or without, that passes the copper layer after back-drilling: that
/// of its pads, all of them together, whatever tracks and planes lie around them. A pad is the hole's if it surrounds
/// it, or if the hole breaks out of it and has its middle in the pad's box. Where there is none (pads that are painted,
/// or were left out on purpose), it is the ring of the one element that leaves most around the hole. Copper of another
/// net does not count; copper without a net does, and around a hole without a net any copper. There a pad that the hole
/// breaks out of counts before one that the drill removes, that one before tracks and planes that the hole cuts into.
/// Widths from `below` (nm) on may be infinite. By hole, rising; holes without a size are left out. Over all cores, the
/// same with any number of threads.
[[nodiscard]] std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below);
/// The same of some of these holes, in their order, without a look at copper elsewhere: a few take little time.
[[nodiscard]] std::vector<AnnularRing> annularRings(const Document& document, LayerId layer,
                                                    std::span<const ElementId> holes, double below);

}  // namespace model
