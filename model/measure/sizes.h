#pragma once

#include <optional>

#include "model/measure/items.h"

namespace model {

/// What is known about one element, in nm and degrees; nothing where it makes no sense (the width of an area).
struct Sizes {
    std::optional<double> width;          ///< of a track; of a trail that of its widest one
    std::optional<double> length;         ///< of a track's middle line
    std::optional<double> radius;         ///< arcs: of the middle line; discs, rings and holes: of the outer edge
    std::optional<double> diameter;       ///< discs, rings and holes
    std::optional<double> innerDiameter;  ///< rings
};
[[nodiscard]] Sizes sizesOf(const Document& document, ElementId element);

/// The angle between two straight tracks, whatever their direction: 0 parallel to 90. Of trails the tracks nearest to
/// each other count. Nothing if one is curved, a dot, or no track.
[[nodiscard]] std::optional<double> angleBetween(const BoardIndex& index, BoardElement a, BoardElement b);

}  // namespace model
