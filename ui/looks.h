#pragma once

#include <vector>

#include "model/document.h"
#include "render/layer_style.h"
#include "ui/models/layer_model.h"

/// Layer looks between the panel (Qt) and the renderer.
namespace ui {

[[nodiscard]] std::vector<models::LayerLook> defaultLooks(const model::Document& document);
[[nodiscard]] std::vector<render::LayerStyle> toStyles(const std::vector<models::LayerLook>& looks);
/// For the 2D view: without the laminate, which would veil all layers below. A valid `contrastLayer` is shown as it is,
/// whatever its check mark, and the others are faint and grey.
[[nodiscard]] std::vector<render::LayerStyle> flatStyles(const model::Document& document,
                                                         const std::vector<models::LayerLook>& looks,
                                                         model::LayerId contrastLayer);

}  // namespace ui
