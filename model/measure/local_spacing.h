#pragma once

#include <optional>
#include <span>

#include "model/index/picking.h"
#include "model/measure/items.h"

namespace model {

/// The spacing at the pointer: from copper to the next copper of the same layer.
struct LocalSpacing {
    Spacing spacing;  ///< nm of the board; square to both edges where these are parallel
    BoardElement from;
    BoardElement to;
    LayerId layer;
};

/// How far away copper still counts, in nm.
inline constexpr double kLocalReach = 10e6;

/// Of every visible copper layer the two pieces of copper nearest to the location that do not touch and are not of one
/// net; of these pairs the one whose farther piece is nearest. The spacing runs from the point of the farther piece
/// that is nearest to the location, the shortest path to the other. Nothing if there are no two within kLocalReach.
/// `layers` as for the picker.
[[nodiscard]] std::optional<LocalSpacing> spacingAt(Picker& picker, PointD location, std::span<const PickLayer> layers);

}  // namespace model
