#pragma once

#include <vector>

#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// A copy of a step as its STEP-REPEAT block lays it down.
struct PlannedCopy {
    std::size_t step = 0;  ///< row of Steps
    Placement placement;
    bool isFlipped = false;
    std::uint32_t line = 0;  ///< of the block
};

/// What one step holds.
struct CopyPlan {
    std::vector<PlannedCopy> copies;  ///< block by block, row by row
    std::size_t total = 1;            ///< the step itself and all copies below it
    int height = 0;                   ///< 0 for a step without copies, else one more than the highest of those it holds
};

/// One plan per step; no step contains itself. Copies of missing steps are left out (collectSteps reported them);
/// loops, more than eight levels and more than kMaxCopies copies are reported and left out.
[[nodiscard]] std::vector<CopyPlan> planCopies(const Steps& steps, Diagnostics& diagnostics);

}  // namespace model::odb
