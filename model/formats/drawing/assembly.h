#pragma once

#include <memory>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/formats/drawing/drawn_job.h"

namespace model::formats {

/// The document of the first step of a job, with the copies of other steps that it holds. Bad rows (of symbols, nets,
/// layers …) are reported with the line of their feature and left out. Nothing that the job does not say is taken over
/// without a diagnostic: outlines derived from the copper, thicknesses, spans. `parseMs` is how long reading took.
/// Errors: Cancelled.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> assemble(DrawnJob job, double parseMs,
                                                                     base::Progress& progress);

}  // namespace model::formats
