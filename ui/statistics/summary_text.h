#pragma once

#include <QString>

#include "model/statistics/board_summary.h"
#include "ui/common/display_units.h"

namespace ui {

/// The board in one line: size and thickness in this unit, how many copper layers, nets, components and holes. Of a
/// panel its own size, and the counts with all copies on it. What is not known is left out.
[[nodiscard]] QString summaryText(const model::BoardSummary& board, LengthUnit unit);

}  // namespace ui
