#pragma once

#include "model/design_rules/rule_context.h"

/// What copper keeps: distances to other nets, to its own, to holes and to the edge; and holes among each other.
namespace model {

/// RuleKind::CopperToCopper between nets, one location for each two nets, of rules that name objects one for each rule
/// (RuleSearch); of nets with an accepted location (RuleScope) up to one for each two elements. Elements that a net tie
/// joins keep none.
void checkNetSpacings(RuleContext& context, LayerId layer, const LayerGeometry& copper);
/// The same within a net: spacings between elements that do not touch each other, unless other copper of the net lies
/// in the middle.
void checkOwnNet(RuleContext& context, LayerId layer, const LayerGeometry& copper);
/// From copper to holes, but for the pad that an NPTH is drilled in, which touches it by design, and for what a net tie
/// joins.
void checkToHoles(RuleContext& context, LayerId layer);
/// Walls of holes count where no pad of theirs lies around them.
void checkToEdge(RuleContext& context, LayerId layer, const LayerGeometry& copper);
/// On all layers at once.
void checkHoles(RuleContext& context);

}  // namespace model
