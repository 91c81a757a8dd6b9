#pragma once

#include <filesystem>
#include <string>

#include "model/base/limits.h"
#include "model/base/result.h"

namespace model {

/// Errors: BadInput, also when it holds more than so many bytes; pipes and devices are read no further than that.
[[nodiscard]] base::Result<std::string> readWholeFile(const std::filesystem::path& path,
                                                      std::uint64_t most = base::kMostFileBytes);

/// Writes all of the text or nothing (FileWriter). Errors: OutputFailed with the path and the reason.
[[nodiscard]] base::Status writeWholeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace model
