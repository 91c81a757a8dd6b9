#pragma once

#include <string_view>

#include "model/measure/items.h"

namespace app {

/// What people write to name something of a board:
///
///     net:GND   part:U1   pin:U1.3   element:123   edge   at:12.3mm,4mm   at:12.3mm,4mm,TOP
///
/// On panels "2/" before it says of which copy of a step (the rows of model::StepTree::copies; 0 is the board itself).
/// Case of names does not matter unless there are several. A part or a pin is all that is called so (PinOfCopy in
/// model/measure/items.h). Errors: BadUsage, with what there is that sounds alike.
[[nodiscard]] base::Result<model::MeasureItem> parseItem(const model::BoardIndex& index, std::string_view text);

/// The net of this name in a copy, for `2/GND` and `GND`. Errors as above.
[[nodiscard]] base::Result<model::NetOfCopy> parseNet(const model::BoardIndex& index, std::string_view text);

}  // namespace app
