#pragma once

#include <string>

#include "model/base/result.h"
#include "render/scene/view_settings.h"

namespace render {

/// Writes a PNG. Errors: OutputFailed with the path and the system's reason; a partial file is removed.
[[nodiscard]] base::Status writePng(const Image& image, const std::string& path);

/// The same in memory. Errors: OutputFailed.
[[nodiscard]] base::Result<std::string> encodePng(const Image& image);

}  // namespace render
