#pragma once

#include <map>
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

    /// The element is milled, and the location (nm) lies beyond the outline of the board, or of a copy in one of its
    /// cut-outs.
    [[nodiscard]] bool has(const model::BoardElement& at, base::PointD location) const;

private:
    struct Copy {
        std::vector<model::ElementId> elements;  ///< milled, rising
        model::EdgeStrips outline;               ///< in nm of the board; of copies of steps that of their cut-outs
    };

    std::map<std::uint32_t, Copy> m_copies;  ///< of which something is milled, the board itself as 0
};

}  // namespace ui
