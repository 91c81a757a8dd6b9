#pragma once

#include "model/design_rules/rule_context.h"

namespace model {

/// RuleKind::Creepage: between nets along the outer face of a copper layer (SurfacePaths), around openings that are at
/// least Rule::leastSlot wide. All copper of the layer counts, covered by solder mask or not; ways over the edge of the
/// board or through a hole to the other face are not searched. One finding per pair of nets and RuleSearch, the
/// shortest way. What a net tie joins keeps none.
void checkCreepage(RuleContext& context, LayerId layer, const LayerGeometry& copper);

}  // namespace model
