#pragma once

#include "ui/parts/part_picking.h"

/// Whose pins a list shows, in a line.
namespace ui {

/// Of PartPicking::parts: "U5: 24 pins on 18 nets"; one on the bottom is "U5 (bottom)".
[[nodiscard]] QString pinsOfPartsText(const PartPicking& parts);
/// "GND: 634 pins of 210 components"; also that a net has no copper. Of several nets "2 nets: …", or how many selected
/// elements have them: "113 elements of 40 nets: …".
[[nodiscard]] QString pinsOfNetsText(const PartPicking& parts, const std::vector<model::BoardNet>& nets,
                                     const std::vector<BoardPin>& pins, std::size_t elements = 0);

}  // namespace ui
