#include "ui/views/layer_styles.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Of layers beside the one in contrast: enough to find one's way, too little to hide anything.
constexpr glm::vec3 kFaintColour{0.55F, 0.57F, 0.60F};
constexpr float kFaintOpacity = 0.12F;

LayerAppearance toLook(const render::LayerStyle& style) {
    return {QColor::fromRgbF(style.colour.r, style.colour.g, style.colour.b),
            static_cast<int>(std::lround(style.opacity * 100.0F)), style.isVisible};
}

render::LayerStyle toStyle(const LayerAppearance& look) {
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
                                            const std::vector<LayerAppearance>& appearances, render::Palette palette,
                                            const model::BoardColourChoice& chosen) {
    std::vector<render::LayerStyle> styles = toStyles(appearances);
    const std::vector<LayerAppearance> untouched = defaultAppearances(document, palette, chosen);
    const std::vector<render::LayerStyle> material =
        render::defaultStyles(document, render::Appearance::Solid, palette, model::boardColours(document, chosen));
    for (std::size_t row = 0; row < styles.size(); ++row) {
        styles[row].material = material[row].material;
        if (appearances[row].colour == untouched[row].colour) {
            styles[row].colour = material[row].colour;
        }
        if (appearances[row].opacityPercent == untouched[row].opacityPercent) {
            styles[row].opacity = material[row].opacity;
        }
    }
    return styles;
}

std::vector<render::LayerStyle> flatStyles(const model::Document& document,
                                           const std::vector<LayerAppearance>& appearances) {
    std::vector<render::LayerStyle> styles = toStyles(appearances);
    std::vector<render::LayerStyle> unveiled = styles;
    for (std::size_t row = 0; row < styles.size(); ++row) {
        unveiled[row].isVisible = styles[row].isVisible && !isVeil(document.layers[row]);
    }
    return std::ranges::any_of(unveiled, &render::LayerStyle::isVisible) ? unveiled : styles;
}

void putOnTop(std::vector<render::LayerStyle>& styles, const model::Document& document, model::LayerId layer) {
    if (!layer.isValid()) {
        return;
    }
    styles[layer.row()].raised = 1;
    for (std::size_t row = 0; row < styles.size(); ++row) {
        if (document.layers[row].spans(layer)) {
            styles[row].raised = 2;
        }
    }
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

std::vector<LayerAppearance> defaultAppearances(const model::Document& document, render::Palette palette,
                                                const model::BoardColourChoice& chosen) {
    std::vector<LayerAppearance> appearances;
    appearances.reserve(document.layers.size());
    const std::vector<render::LayerStyle> drawing = render::defaultStyles(document, render::Appearance::Flat, palette);
    for (render::LayerStyle style :
         render::defaultStyles(document, render::Appearance::Solid, palette, model::boardColours(document, chosen))) {
        const std::size_t row = appearances.size();
        style.colour = isVeil(document.layers[row]) ? style.colour : drawing[row].colour;
        appearances.push_back(toLook(style));
    }
    return appearances;
}

std::vector<render::LayerStyle> toStyles(const std::vector<LayerAppearance>& appearances) {
    std::vector<render::LayerStyle> styles;
    styles.reserve(appearances.size());
    for (const LayerAppearance& look : appearances) {
        styles.push_back(toStyle(look));
    }
    return styles;
}

}  // namespace ui
