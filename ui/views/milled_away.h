#pragma once

#include <optional>
#include <vector>

#include "model/index/board_index.h"
#include "model/solids/region_distance.h"
#include "ui/workspace/loader.h"

namespace ui {

/// Which locations of elements a view of the board as fabricated does not show (model/solids/milling.h): nothing is
/// picked there.
class MilledAway {
public:
    MilledAway() = default;
    explicit MilledAway(const LoadedBoard& board);

    /// The element is milled, and the location (nm) lies beyond the outline of the board.
    [[nodiscard]] bool has(const model::BoardElement& at, base::PointD location) const;

private:
    std::vector<model::ElementId> m_elements;    ///< of the board itself, rising
    std::optional<model::EdgeStrips> m_outline;  ///< none: nothing is milled
};

}  // namespace ui
