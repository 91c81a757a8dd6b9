#pragma once

#include <filesystem>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/generate/layout.h"

namespace model::generate {

/// Writes a made-up board of exactly these elements as a text model of the paper whose areas have NURBS edges
/// (model_text.h). The same arguments give the same text; memory does not grow with the board. Errors as of writeJob
/// (job_writer.h).
[[nodiscard]] base::Status writeModel(const Wanted& wanted, const std::filesystem::path& path,
                                      base::Progress& progress);

}  // namespace model::generate
