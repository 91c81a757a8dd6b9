#pragma once

#include "model/agreement/agreement.h"
#include "model/agreement/flat_board.h"

namespace model {

/// Pins that two boards have in common, by row of FlatBoard::pins.
struct MatchedParts {
    Comparison parts;
    Comparison pins;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> samePins;
};

/// `reach`: as of reachOf, before `b` was shifted.
[[nodiscard]] MatchedParts compareParts(const FlatBoard& a, const FlatBoard& b, Nm reach,
                                        const AgreementRequest& request);

}  // namespace model
