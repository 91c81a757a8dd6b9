#pragma once

#include <string>

#include "model/base/result.h"
#include "render/scene/view_settings.h"

namespace render {

/// A PNG in memory. Errors: OutputFailed.
[[nodiscard]] base::Result<std::string> encodePng(const Image& image);

}  // namespace render
