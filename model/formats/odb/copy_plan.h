#pragma once

#include <vector>

#include "model/formats/odb/steps/step.h"
#include "model/formats/steps/step_copies.h"

namespace model::odb {

/// One plan per step; no step contains itself. Copies of missing steps are left out (collectSteps reported them);
/// loops, more than eight levels and more than base::kMostCopies copies are reported and left out.
[[nodiscard]] std::vector<formats::CopyPlan> planCopies(const Steps& steps, Diagnostics& diagnostics);

}  // namespace model::odb
