#pragma once

#include <optional>
#include <string_view>

#include "model/clearance/rule_file.h"

namespace model {

/// Minimums of KiCad's custom rules (.kicad_dru): clearance, edge_clearance, hole_clearance, hole_to_hole,
/// hole_size (of slots their width), annular_width, track_width, silk_clearance and creepage, with a layer and
/// conditions (rulesUnder). Later rules go before earlier ones there as here. The file does not say which nets a net
/// class has: those classes come without nets, which leaves their rules incomplete until someone names some. What has
/// no counterpart is left out and named with its line; that may be all of it. So are, by what they say, rules for more
/// than kMostNetClasses (leaveOutExcessClasses). A rule that KiCad is to ignore is off and named in `unused`. Errors:
/// BadInput.
[[nodiscard]] base::Result<RuleFile> parseKicadRules(std::string_view text);

/// Clearances above `least` that zones, pads and footprints of a board (.kicad_pcb) ask for themselves, with the line
/// of the first one: KiCad checks them, and a table of rules has no place for them. None if there are none.
[[nodiscard]] std::optional<LeftOutRule> clearancesOfItems(std::string_view board, Nm least);

}  // namespace model
