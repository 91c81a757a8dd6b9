#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "model/document.h"

namespace render {

/// How a layer looks; one per layer of the document, edited by the layers panel and the command line.
struct LayerStyle {
    glm::vec3 colour{0.5F};  ///< sRGB, 0 to 1: the canvas colour is the panel colour
    float opacity = 1.0F;    ///< below 1 the layer is blended over what lies beneath
    bool isVisible = true;
};

/// Colours by layer type as users know them (top copper red, bottom blue, inner layers distinct hues, mask green, silk
/// white); documentation layers and component layers start hidden.
[[nodiscard]] std::vector<LayerStyle> defaultStyles(const model::Document& document);

}  // namespace render
