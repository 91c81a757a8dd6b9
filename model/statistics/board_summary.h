#pragma once

#include <cstdint>
#include <span>

#include "model/board/holes.h"

namespace model {

/// What a board is in a few numbers.
struct BoardSummary {
    std::int64_t width = 0;  ///< nm, of the extent of its outline; of a panel that of the panel
    std::int64_t height = 0;
    bool isSizeAssumed = false;  ///< the job has no outline: it is the extent of its copper, or of all that it draws
    Nm thickness = 0;
    std::size_t copperLayers = 0;
    /// With those of all copies of steps on it.
    std::uint64_t nets = 0;
    std::uint64_t components = 0;
    std::uint64_t holes = 0;
    bool hasCopies = false;  ///< it is a panel
};

/// `drills`: its drillTableWithCopies.
[[nodiscard]] BoardSummary summaryOf(const Document& board, std::span<const DrillRow> drills);

}  // namespace model
