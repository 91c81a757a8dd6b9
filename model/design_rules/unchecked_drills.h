#pragma once

#include <vector>

#include "model/clearance/rule_choice.h"
#include "model/clearance/rule_report.h"

namespace model {

/// Holes that rules of hole-size, slot-width and aspect-ratio cannot be held against: those without a size, slots that
/// are drawn as areas, and of an aspect ratio those whose depth is not known (HoleDepths). Each is counted for the rule
/// that would hold for it.
[[nodiscard]] std::vector<Unchecked> uncheckedDrills(const Document& document, const RuleChoice& choice);

}  // namespace model
