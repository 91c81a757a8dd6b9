#pragma once

#include "model/agreement/agreement.h"
#include "model/agreement/flat_board.h"

namespace model {

[[nodiscard]] Comparison compareHoles(const FlatBoard& a, const FlatBoard& b, const AgreementRequest& request);

}  // namespace model
