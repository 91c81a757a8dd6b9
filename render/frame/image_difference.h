#pragma once

#include "render/scene/view_settings.h"

namespace render {

/// Mean squared difference of grey levels (0 to 1, sRGB luma) over all pixels, as the paper compares its pipelines
/// (there below 0.03). Pictures of different size differ by 1.
[[nodiscard]] double greyMse(const Image& a, const Image& b);

}  // namespace render
