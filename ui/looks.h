#pragma once

#include <span>
#include <vector>

#include "model/document.h"
#include "render/layer_style.h"
#include "ui/models/layer_model.h"

/// Layer looks between the panel (Qt) and the renderer.
namespace ui {

/// The colours of a drawing (render::Look::Flat), with everything visible that makes up a solid board.
[[nodiscard]] std::vector<models::LayerLook> defaultLooks(const model::Document& document, render::Palette palette);
[[nodiscard]] std::vector<render::LayerStyle> toStyles(const std::vector<models::LayerLook>& looks);
/// For the 3D view: layers whose colour nobody changed have that of their material.
[[nodiscard]] std::vector<render::LayerStyle> solidStyles(const model::Document& document,
                                                          const std::vector<models::LayerLook>& looks,
                                                          render::Palette palette);
/// For the 2D view: without laminate and lacquer, which would veil all layers below.
[[nodiscard]] std::vector<render::LayerStyle> flatStyles(const model::Document& document,
                                                         const std::vector<models::LayerLook>& looks);
/// These layers are shown as they are, whatever their check marks, and all others are faint and grey. None of them:
/// nothing changes.
void putInContrast(std::vector<render::LayerStyle>& styles, std::span<const model::LayerId> layers);

}  // namespace ui
