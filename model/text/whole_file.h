#pragma once

#include <filesystem>
#include <string>

#include "model/base/result.h"

namespace model {

/// Errors: BadInput.
[[nodiscard]] base::Result<std::string> readWholeFile(const std::filesystem::path& path);

/// Writes all of the text or nothing (FileWriter). Errors: OutputFailed with the path and the reason.
[[nodiscard]] base::Status writeWholeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace model
