#pragma once

#include <optional>

#include "model/measure/items.h"

namespace model {

/// What can be told of one element, in nm and degrees; nothing where it makes no sense (the width of an area).
struct Sizes {
    std::optional<double> width;          ///< of a stroke; of a trail that of its widest one
    std::optional<double> length;         ///< of a stroke's middle line
    std::optional<double> radius;         ///< arcs: of the middle line; discs, rings and holes: of the outer edge
    std::optional<double> diameter;       ///< discs, rings and holes
    std::optional<double> innerDiameter;  ///< rings
    std::optional<double> sweepDeg;       ///< arcs: how far they turn, above 0
};
[[nodiscard]] Sizes sizesOf(const Document& document, ElementId element);

/// The angle between two straight strokes, whatever their direction: 0 parallel to 90. Of trails the strokes nearest to
/// each other count. Nothing if one is curved, a dot, or no stroke.
[[nodiscard]] std::optional<double> angleBetween(const BoardIndex& index, BoardElement a, BoardElement b);

}  // namespace model
