#pragma once

#include <vector>

#include "model/formats/ipc2581/step_reader.h"

namespace model::ipc2581 {

/// Moves the steps into the job, the one to show first, and places their copies of each other. Steps that the shown one
/// does not hold keep their names only. `rows` are the layers' rows in the job by row of the LayerList. Steps that
/// contain themselves and copies beyond reason are reported and left out.
void addSteps(Reading& reading, std::vector<SourceStep> steps, std::size_t shown, const std::vector<std::int32_t>& rows,
              formats::DrawnJob& job);

}  // namespace model::ipc2581
