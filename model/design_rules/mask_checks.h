#pragma once

#include "model/design_rules/rule_context.h"

/// Checks of solder mask and silkscreen against each other and against the outer copper beneath them.
namespace model {

/// RuleKind::MaskSliver: of what lies between two openings. Openings no farther apart than the table's tolerance abut:
/// programs round their edges.
void checkSlivers(RuleContext& context, LayerId mask);
/// RuleKind::MaskToCopper: of each pad in an opening what the opening leaves around it; where several openings lie
/// around it, the one that leaves most. Pads larger than their opening (defined by solder mask) are noted, not held
/// against it.
void checkMaskToCopper(RuleContext& context, LayerId mask);
/// RuleKind::MaskToForeign: an opening is for the pads it touches, else for the vias, else for any copper it touches,
/// else for what the openings are for that it meets; copper of other nets keeps its distance. One finding per opening,
/// net and RuleSearch.
void checkMaskToForeign(RuleContext& context, LayerId mask);
/// RuleKind::SilkToPad: of printed silkscreen to pads that an opening of the solder mask touches; without a layer of
/// solder mask on that face to all pads. Vias do not count. One finding per pad.
void checkSilkscreen(RuleContext& context, LayerId silkscreen);

}  // namespace model
