#pragma once

#include <optional>

#include "model/document_builder.h"
#include "model/odb/step.h"

namespace model::odb {

/// Builds the document from parsed steps (row 0 is the chosen one). Diagnostics of the parsers are taken over in the
/// order of steps and layers. False when cancelled.
[[nodiscard]] bool buildJob(const JobContext& job, const Steps& steps, std::optional<double> boardNm,
                            DocumentBuilder& builder, base::Progress& progress);

}  // namespace model::odb
