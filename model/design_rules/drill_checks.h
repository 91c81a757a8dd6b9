#pragma once

#include "model/design_rules/rule_context.h"

namespace model {

/// RuleKind::HoleSize, SlotWidth and AspectRatio: what a drill or router makes, as it is drilled, before it is plated.
/// One finding for each hole, in its middle, on the layer of its drill; a hole that the job has twice counts once.
/// Slots and routed paths are as wide as their narrowest part; holes that are drawn as areas are not measured
/// (unchecked_items.h).
void checkDrills(RuleContext& context);

}  // namespace model
