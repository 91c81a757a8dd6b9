#pragma once

#include <span>
#include <vector>

#include "model/board/document.h"
#include "render/scene/layer_style.h"
#include "ui/layers/layer_model.h"

/// Layer looks between the panel (Qt) and the renderer.
namespace ui {

/// The colours of a drawing (render::Appearance::Flat), with everything visible that makes up a solid board. What the
/// drawing leaves out (flatStyles) has the colour it has on the board.
[[nodiscard]] std::vector<LayerAppearance> defaultAppearances(const model::Document& document, render::Palette palette,
                                                              const model::BoardColourChoice& chosen = {});
[[nodiscard]] std::vector<render::LayerStyle> toStyles(const std::vector<LayerAppearance>& appearances);
/// For the 3D view: layers are of their material, those whose colour nobody changed in its colour. The film of a solder
/// mask whose opacity nobody changed is as opaque as its colour needs.
[[nodiscard]] std::vector<render::LayerStyle> solidStyles(const model::Document& document,
                                                          const std::vector<LayerAppearance>& appearances,
                                                          render::Palette palette,
                                                          const model::BoardColourChoice& chosen);
/// For the 2D view: without substrate and solder mask, which would veil all layers below, unless nothing else is visible.
[[nodiscard]] std::vector<render::LayerStyle> flatStyles(const model::Document& document,
                                                         const std::vector<LayerAppearance>& appearances);
/// In 2D this layer is drawn over the others, and the holes through it over that; none: nothing changes.
void putOnTop(std::vector<render::LayerStyle>& styles, const model::Document& document, model::LayerId layer);
/// These layers are shown as they are, whatever their check marks, and all others are faint and grey. None of them:
/// nothing changes.
void putInContrast(std::vector<render::LayerStyle>& styles, std::span<const model::LayerId> layers);

}  // namespace ui
