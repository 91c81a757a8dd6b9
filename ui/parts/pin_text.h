#pragma once

#include "ui/parts/part_picking.h"

/// Whose pins a list shows, in a line.
namespace ui {

/// Of PartPicking::parts: "U5: 24 pins on 18 nets"; one on the bottom is "U5 (bottom)".
[[nodiscard]] QString pinsOfPartsText(const PartPicking& parts);
/// "GND: 634 pins of 210 components"; also that a net has no copper.
[[nodiscard]] QString pinsOfNetsText(const PartPicking& parts, const std::vector<model::BoardNet>& nets,
                                     const std::vector<BoardPin>& pins);

}  // namespace ui
