#pragma once

#include <filesystem>
#include <string>

#include "model/base/result.h"

namespace model {

/// Errors: BadInput.
[[nodiscard]] base::Result<std::string> readWholeFile(const std::filesystem::path& path);

/// Writes all of the text or nothing: a file beside it is written out and then renamed; a link stays one. What is no plain file, as a
/// pipe or a device, is written to as it is. Errors: OutputFailed with the path and the reason.
[[nodiscard]] base::Status writeWholeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace model
