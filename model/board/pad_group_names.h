#pragma once

#include <string_view>

/// Groups of pads that a footprint of KiCad declares. They are properties of its component, one for each group, whose
/// value lists the numbers of its pads: "1, 2". Readers of other formats write none.
namespace model {

/// Pads that copper may join although their nets differ.
inline constexpr std::string_view kNetTieGroup = "net_tie_pad_groups";
/// Pads that the part joins inside.
inline constexpr std::string_view kJumperGroup = "jumper_pad_groups";
/// With any value: pads of one number are such a group.
inline constexpr std::string_view kDuplicatesAreJumpers = "duplicate_pad_numbers_are_jumpers";

}  // namespace model
