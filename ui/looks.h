#pragma once

#include <vector>

#include "model/document.h"
#include "render/layer_style.h"
#include "ui/models/layer_model.h"

/// Layer looks between the panel (Qt) and the renderer.
namespace ui {

[[nodiscard]] std::vector<models::LayerLook> defaultLooks(const model::Document& document);
[[nodiscard]] std::vector<render::LayerStyle> toStyles(const std::vector<models::LayerLook>& looks);

}  // namespace ui
