#pragma once

#include <vector>

#include "render/scene/layer_style.h"

namespace app {

/// Makes the bodies of the components visible: pictures and measurements are of bare boards otherwise.
void showComponents(const model::Document& document, std::vector<render::LayerStyle>& styles);

}  // namespace app
