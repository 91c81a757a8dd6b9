#pragma once

#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/steps/step_copies.h"

namespace model::formats {

/// One plan per step. Copies of steps that do not lie behind the one that holds them, more than base::kMostStepDepth
/// levels and more than base::kMostCopies copies are reported and left out.
[[nodiscard]] std::vector<CopyPlan> planCopies(const DrawnJob& job, Diagnostics& diagnostics);

}  // namespace model::formats
