#pragma once

#include <optional>

#include "model/board/document_builder.h"
#include "model/formats/odb/steps/step.h"

namespace model::odb {

/// Builds the document of the chosen step (row 0), and before it those of the steps it holds copies of. Each document
/// lists what its own files gave reason to say, the chosen one all of it, in the order of steps and layers. False when
/// cancelled.
[[nodiscard]] bool buildJob(const JobContext& job, const Steps& steps, std::optional<double> boardNm,
                            DocumentBuilder& builder, base::Progress& progress);

}  // namespace model::odb
