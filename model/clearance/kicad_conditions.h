#pragma once

#include <string_view>
#include <vector>

#include "model/clearance/design_rules.h"

namespace model {

/// The rules that ask for the same as `rule`, which names no nets, holes or objects yet, where a condition of KiCad
/// holds; one or more for each alternative. Empty if some of the condition has no counterpart.
///
/// Known of A and B: Type, NetClass, NetName and Layer, hasNetclass() and hasExactNetclass(), isPlated(), isMicroVia(),
/// whether they are NPTHs by Pad_Type, and whether the two are of one net or not, each where the kind of rule can tell;
/// A and B may stand either way round. Of holes, Type is known of NPTHs alone, which are pads in KiCad. Not known is
/// the class Default: what is in no other class is not named by anything here.
[[nodiscard]] std::vector<Rule> rulesUnder(const Rule& rule, std::string_view condition);

}  // namespace model
