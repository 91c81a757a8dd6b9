#pragma once

#include <optional>
#include <vector>

#include "model/geometry/edges.h"
#include "model/measure/items.h"

/// The annular ring as it is measured: what one piece of copper leaves around one hole.
namespace model {

/// From the edge of a hole, as it is drilled, to that of the copper around it: the least distance, exact; `from` lies
/// on the edge of the hole. Nothing where no figure of the copper surrounds all of the hole.
[[nodiscard]] std::optional<Spacing> annularRing(const FigureTable& hole, const FigureTable& copper);

/// The same of two items of which one is a single hole and the other a single piece of copper on a layer that the hole
/// passes, of one net with it unless one of them has none; from the first item to the second. Nothing of others.
[[nodiscard]] std::optional<Spacing> annularRing(const BoardIndex& index, const Pieces& a, const Pieces& b);

/// The only hole that goes through a pad of copper, and what the pad leaves around it.
struct PadHole {
    ElementId hole;               ///< of the step
    std::optional<Spacing> ring;  ///< none: it breaks out of the pad; in the coordinates of the step
};
/// Plated holes of the pad's net or of none with their middle within its box, which reach its layer after
/// back-drilling. Nothing of other elements, and of pads with several such holes.
[[nodiscard]] std::optional<PadHole> holeInPad(const BoardIndex& index, BoardElement pad);

}  // namespace model
