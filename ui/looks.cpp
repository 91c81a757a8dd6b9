#include "ui/looks.h"

#include <cmath>

namespace ui {

namespace {

models::LayerLook toLook(const render::LayerStyle& style) {
    return {QColor::fromRgbF(style.colour.r, style.colour.g, style.colour.b),
            static_cast<int>(std::lround(style.opacity * 100.0F)), style.isVisible};
}

render::LayerStyle toStyle(const models::LayerLook& look) {
    return {{look.colour.redF(), look.colour.greenF(), look.colour.blueF()},
            static_cast<float>(look.opacityPercent) / 100.0F,
            look.isVisible};
}

}  // namespace

std::vector<models::LayerLook> defaultLooks(const model::Document& document) {
    std::vector<models::LayerLook> looks;
    looks.reserve(document.layers.size());
    for (const render::LayerStyle& style : render::defaultStyles(document)) {
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
