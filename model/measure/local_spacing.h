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

/// On a pad: of every visible copper layer whose pad or hole covers the location, from it to the copper nearest to it,
/// wherever on it the location is; of several layers the least spacing.
///
/// Else of every visible copper layer the two pieces of copper nearest to the location, such as a track or pour and
/// what lies beside it; of these pairs the one whose farther piece is nearest. The spacing is the least there is around
/// the location: no end of it comes closer to the other piece by moving a little, while far from the location the two
/// may be closer. Both run from the farther piece to the nearer one.
///
/// Pieces that touch or are of one net have no spacing. Nothing if there are no two within kLocalReach. `layers` as for
/// the picker.
[[nodiscard]] std::optional<LocalSpacing> spacingAt(Picker& picker, PointD location, std::span<const PickLayer> layers);

}  // namespace model
