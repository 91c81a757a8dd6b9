#pragma once

#include "model/agreement/part_agreement.h"

namespace model {

/// The comparisons of nets and of their names, by the pins that both boards have and by pads that lie on one another.
/// Pins and pads alone in their net are the same as without a net; but if such nets have different names, one of which
/// the other board has elsewhere, the names differ. `reach`: as of reachOf, before `b` was shifted.
[[nodiscard]] std::vector<Comparison> compareNets(const FlatBoard& a, const FlatBoard& b, const MatchedParts& parts,
                                                  Nm reach, const AgreementRequest& request);

}  // namespace model
