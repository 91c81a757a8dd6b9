#pragma once

#include "render/scene/view_settings.h"

namespace render {

/// The picture that looks like `onBlack` over black and like `onWhite` over white: without background, with as much
/// alpha as the background does not shine through. Both are of one scene and equally large; where they differ by
/// rounding only, alpha is whole. Colours are sRGB, mixing is linear, as it is when drawing.
[[nodiscard]] Image withoutBackground(const Image& onBlack, const Image& onWhite);

}  // namespace render
