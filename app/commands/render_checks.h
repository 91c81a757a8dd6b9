#pragma once

#include <vector>

#include "app/commands/render_command.h"
#include "render/scene/layer_style.h"

namespace app {

/// What is wrong with the arguments of `render` themselves, before a board is read. Errors: BadUsage.
[[nodiscard]] base::Status checkArguments(const RenderArguments& arguments);

/// Arguments for what is not among what is drawn of a board: `styles` by layer. Errors: BadUsage.
[[nodiscard]] base::Status checkDrawn(const RenderArguments& arguments, const model::Document& document,
                                      const std::vector<render::LayerStyle>& styles);

}  // namespace app
