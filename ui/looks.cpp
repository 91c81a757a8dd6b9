#include "ui/looks.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Of layers beside the one in contrast: enough to find one's way, too little to hide anything.
constexpr glm::vec3 kFaintColour{0.55F, 0.57F, 0.60F};
constexpr float kFaintOpacity = 0.12F;

models::LayerLook toLook(const render::LayerStyle& style) {
    return {QColor::fromRgbF(style.colour.r, style.colour.g, style.colour.b),
            static_cast<int>(std::lround(style.opacity * 100.0F)), style.isVisible};
}

render::LayerStyle toStyle(const models::LayerLook& look) {
    return {{look.colour.redF(), look.colour.greenF(), look.colour.blueF()},
            static_cast<float>(look.opacityPercent) / 100.0F,
            look.isVisible};
}

bool isVeil(const model::Layer& layer) {
    using model::LayerType;
    return layer.isSynthetic && (layer.type == LayerType::Body || layer.type == LayerType::SolderMask);
}

}  // namespace

std::vector<render::LayerStyle> solidStyles(const model::Document& document,
                                            const std::vector<models::LayerLook>& looks, render::Palette palette) {
    std::vector<render::LayerStyle> styles = toStyles(looks);
    const std::vector<models::LayerLook> untouched = defaultLooks(document, palette);
    const std::vector<render::LayerStyle> material = render::defaultStyles(document, render::Look::Solid, palette);
    for (std::size_t row = 0; row < styles.size(); ++row) {
        if (looks[row].colour == untouched[row].colour) {
            styles[row].colour = material[row].colour;
        }
    }
    return styles;
}

std::vector<render::LayerStyle> flatStyles(const model::Document& document,
                                           const std::vector<models::LayerLook>& looks) {
    std::vector<render::LayerStyle> styles = toStyles(looks);
    for (std::size_t row = 0; row < styles.size(); ++row) {
        styles[row].isVisible = styles[row].isVisible && !isVeil(document.layers[row]);
    }
    return styles;
}

void putInContrast(std::vector<render::LayerStyle>& styles, std::span<const model::LayerId> layers) {
    for (std::size_t row = 0; row < styles.size() && !layers.empty(); ++row) {
        render::LayerStyle& style = styles[row];
        if (std::ranges::find(layers, model::LayerId{row}) != layers.end()) {
            style.isVisible = true;
            style.opacity = 1.0F;
        } else {
            style.colour = kFaintColour;
            style.opacity = std::min(style.opacity, kFaintOpacity);
        }
    }
}

std::vector<models::LayerLook> defaultLooks(const model::Document& document, render::Palette palette) {
    std::vector<models::LayerLook> looks;
    looks.reserve(document.layers.size());
    const std::vector<render::LayerStyle> drawing = render::defaultStyles(document, render::Look::Flat, palette);
    for (render::LayerStyle style : render::defaultStyles(document, render::Look::Solid, palette)) {
        style.colour = drawing[looks.size()].colour;
        looks.push_back(toLook(style));
    }
    return looks;
}

std::vector<render::LayerStyle> toStyles(const std::vector<models::LayerLook>& looks) {
    std::vector<render::LayerStyle> styles;
    styles.reserve(looks.size());
    for (const models::LayerLook& look : looks) {
        styles.push_back(toStyle(look));
    }
    return styles;
}

}  // namespace ui
