#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "model/board/board_colours.h"

namespace render {

/// How a surface takes the light in 3D; the values of shader::kMaterialMatt and so on.
enum class Material : std::uint8_t {
    Matt,   ///< the same from everywhere
    Metal,  ///< mirrors the light in its own colour
    Gloss   ///< mirrors some of it over its own colour; a translucent one is stained glass, not a veil
};

/// How a layer looks; one per layer of the document, edited by the layers panel and the command line.
struct LayerStyle {
    glm::vec3 colour{0.5F};  ///< sRGB, 0 to 1: the canvas colour is the panel colour
    float opacity = 1.0F;    ///< below 1 the layer is blended over what lies beneath
    bool isVisible = true;
    /// In 2D it is drawn over all layers that are raised less, seen from either side.
    std::uint8_t raised = 0;
    Material material = Material::Matt;
};

enum class Appearance {
    Flat,  ///< a drawing, seen in 2D: top copper red, bottom blue; solder mask and bodies of components hidden
    Solid  ///< a board, seen in 3D: copper with its finish under glossy solder mask, amber where it is flexible
};

enum class Palette {
    Standard,        ///< as in other programs: top red, bottom blue, solder mask green
    ColourBlindSafe  ///< after Okabe and Ito, with steps of lightness; distinguished with protanopia and deuteranopia
                     ///< too
};

/// Colours by layer type as users know them (inner layers distinct hues, silk white); mask openings, documentation and
/// component layers start hidden.
[[nodiscard]] std::vector<LayerStyle> defaultStyles(const model::Document& document,
                                                    Appearance appearance = Appearance::Solid,
                                                    Palette palette = Palette::Standard);
/// The same with other colours of solder mask, silkscreen and finish, for Appearance::Solid.
[[nodiscard]] std::vector<LayerStyle> defaultStyles(const model::Document& document, Appearance appearance,
                                                    Palette palette, const model::BoardColours& chosen);

}  // namespace render
