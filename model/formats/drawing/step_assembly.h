#pragma once

#include "model/formats/drawing/layer_rows.h"
#include "model/formats/steps/step_copies.h"
#include "model/formats/steps/step_progress.h"

namespace model::formats {

/// What is the same for all steps of a job.
struct AssemblyParts {
    const DrawnJob& job;
    const LayerRows& layers;
    const std::vector<CopyPlan>& plans;
    StepDocuments& documents;
    StepProgress& progress;
};

/// Fills the document of a step, whose layers are in `builder` already. False when cancelled.
[[nodiscard]] bool assembleStep(const AssemblyParts& parts, std::size_t step, DocumentBuilder& builder);

}  // namespace model::formats
