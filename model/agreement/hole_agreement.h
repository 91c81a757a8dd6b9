#pragma once

#include "model/agreement/agreement.h"
#include "model/agreement/flat_board.h"

namespace model {

/// `reach`: as of reachOf, before `b` was shifted.
[[nodiscard]] Comparison compareHoles(const FlatBoard& a, const FlatBoard& b, Nm reach,
                                      const AgreementRequest& request);

}  // namespace model
