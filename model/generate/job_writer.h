#pragma once

#include <filesystem>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/generate/layout.h"

namespace model::generate {

/// Writes a made-up board of exactly these elements as a packed ODB++ job (.tgz). The same arguments give the same job.
/// Memory does not grow with the board: every file is worked out twice, once for its size and once for its bytes.
/// All of the file or nothing: what had the name before stays until then (model/text/file_writer.h). Errors: BadUsage
/// (too large for a job's coordinates), OutputFailed with the reason, Cancelled.
[[nodiscard]] base::Status writeJob(const Wanted& wanted, const std::filesystem::path& path, base::Progress& progress);

}  // namespace model::generate
