#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "model/index/board_index.h"
#include "ui/common/display_units.h"

/// What is known of an element, in words.
namespace ui {

using Facts = std::vector<std::pair<QString, QString>>;  ///< name and value

/// Everything: kind, sizes, the hole in a pad, layer, net, symbol, position, attributes, file and line. `at` must be an
/// element of the board. Of one in a copy the layer and the position are those on the board.
[[nodiscard]] Facts factsOf(const model::BoardIndex& index, const model::BoardElement& at, LengthUnit unit);

/// The same in a few words for a tip: "Trail, 0.25 mm wide · TOP · GND".
[[nodiscard]] QString summaryOf(const model::BoardIndex& index, const model::BoardElement& at, LengthUnit unit);

}  // namespace ui
