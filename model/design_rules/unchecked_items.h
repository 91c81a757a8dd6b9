#pragma once

#include <string>
#include <vector>

#include "model/clearance/rule_choice.h"
#include "model/clearance/rule_report.h"

namespace model {

/// What rules cannot be held against on a document, because not all of the job could be read, which leaves all rules
/// incomplete, or because it does not say enough: copper without any nets, a
/// board without an outline of its own, holes without a span or a size or that are drawn as areas, a board whose
/// thickness is assumed, copies of steps that lie too close to each other, net classes without nets, names of net
/// classes that no net has. Layers of rigid-flex boards with an outline of their own are held against that of the board
/// alone. By rule.
[[nodiscard]] std::vector<Unchecked> uncheckedItems(const Document& document, const RuleTable& table,
                                                    const RuleChoice& choice);

/// "no net fits VCC_* of the net class power": patterns with * or ? that fit nothing, of classes that rules name and
/// that have nets. A note and no more: one file may be for several boards.
[[nodiscard]] std::vector<std::string> patternsOfNothing(const RuleTable& table, const RuleChoice& choice);

}  // namespace model
