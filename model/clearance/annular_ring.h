#pragma once

#include <vector>

#include "model/board/document.h"
#include "model/geometry/edges.h"

namespace model {

/// What is left of a pad around a plated hole.
struct AnnularRing {
    ElementId hole;
    ElementId pad;  ///< the element that leaves most of itself around the hole
    Spacing width;  ///< from the edge of the hole to the nearest edge of the pad, nm; 0: the hole breaks out
};

/// The rings on a copper layer that are smaller than `below` (nm), by hole. A hole's ring is that of the one element
/// of its net that leaves most around it: pads, tracks and planes alike, so copper made of several elements may leave
/// more than is said. Holes that meet no copper of their net on the layer have no ring there; those of
/// `holesWithoutRings` are left out.
[[nodiscard]] std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below);

/// Plated holes whose rings are not measured.
struct HolesWithoutRings {
    std::size_t notRound = 0;
    std::size_t withoutNet = 0;  ///< round ones
};
[[nodiscard]] HolesWithoutRings holesWithoutRings(const Document& document);

}  // namespace model
