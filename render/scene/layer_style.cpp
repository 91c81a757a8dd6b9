#include "render/scene/layer_style.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/board/layers.h"
#include "shaders/shared/board.h"

namespace render {

using model::Layer;
using model::LayerSide;
using model::LayerType;

namespace {

constexpr glm::vec3 rgb(unsigned value) {
    return {static_cast<float>(value >> 16U & 0xffU) / 255.0F, static_cast<float>(value >> 8U & 0xffU) / 255.0F,
            static_cast<float>(value & 0xffU) / 255.0F};
}

struct Colours {
    // Of a drawing.
    glm::vec3 top;
    glm::vec3 bottom;
    /// Apart from each other and from the outer ones, so that a board with 40 copper layers has no colour twice. Those
    /// after the tenth were searched on a grid, dull enough to leave the bright ones to highlights.
    std::array<glm::vec3, 38> inner;
    // Of a board.
    glm::vec3 topMetal;
    glm::vec3 bottomMetal;
    glm::vec3 solderMask;
    glm::vec3 substrate;
};

constexpr Colours kColours[] = {
    {rgb(0xd04a3c),
     rgb(0x3d78d8),
     {rgb(0xd8b030), rgb(0x3fa76b), rgb(0xb56cc8), rgb(0xe08040), rgb(0x46b3b8), rgb(0x9aa83c), rgb(0xd86a92),
      rgb(0x7f86d0), rgb(0x58a040), rgb(0xc08a60), rgb(0x486040), rgb(0xf0d0f8), rgb(0x50f8f8), rgb(0x006088),
      rgb(0x00b0f0), rgb(0xb8f0a0), rgb(0x884850), rgb(0xf8d898), rgb(0x987000), rgb(0x087070), rgb(0xa8d8f8),
      rgb(0x705078), rgb(0x88a888), rgb(0xf8b0b0), rgb(0xa02878), rgb(0xa82848), rgb(0x984000), rgb(0x106828),
      rgb(0xa8f0d0), rgb(0xb888a8), rgb(0xe8e870), rgb(0xf88080), rgb(0xf8a0e0), rgb(0x785838), rgb(0x506800),
      rgb(0x6848a8), rgb(0x58f8b8), rgb(0x888040)},
     rgb(0xe6b450),
     rgb(0xe6b450),
     rgb(0x0c6e38),
     rgb(0x86804a)},
    // Orange, blue, yellow, sky, purple, green, moved until the layers of a board with six
    // are as far apart as layer_style_test states.
    {rgb(0xc67b01),
     rgb(0x0654b9),
     {rgb(0xf0d837), rgb(0x63d1ff), rgb(0x7b2b70), rgb(0x05a65a), rgb(0xf4b6a0), rgb(0x8a5a2a), rgb(0xb4e4c8),
      rgb(0x3a2f6e), rgb(0xa39a3c), rgb(0xe48fc0), rgb(0x980830), rgb(0x005000), rgb(0xc8f080), rgb(0x08a8a0),
      rgb(0x1870a0), rgb(0xa8a8f8), rgb(0xf87860), rgb(0x00d8b0), rgb(0xf0e8a8), rgb(0xa05860), rgb(0x80a870),
      rgb(0x9060c0), rgb(0xd0b8d0), rgb(0xf06088), rgb(0x005058), rgb(0x882800), rgb(0x806890), rgb(0x60f8f8),
      rgb(0x609028), rgb(0xf8b868), rgb(0x00a0f8), rgb(0x80a8b0), rgb(0xc850a0), rgb(0xe898f8), rgb(0x88f8a0),
      rgb(0xa89068), rgb(0x585800), rgb(0x206848)},
     rgb(0xf0c860),
     rgb(0xd09040),
     rgb(0x0a4878),
     rgb(0x8c8468)}};

struct TypeStyle {
    LayerType type;
    LayerStyle style;
};

// What is not copper. Sides that differ have the top's style here; the bottom's is darker.
const TypeStyle kTypeStyles[] = {
    {LayerType::Dielectric, {rgb(0xb8a05a), 0.25F, false}}, {LayerType::Body, {rgb(0x3d6b4a), 0.45F, true}},
    {LayerType::SolderMask, {rgb(0x2fa060), 0.55F, false}}, {LayerType::SolderPaste, {rgb(0xa0a4ac), 1.0F, false}},
    {LayerType::SilkScreen, {rgb(0xeeeedd), 1.0F, true}},   {LayerType::Drill, {rgb(0xb98a48), 1.0F, true}},
    {LayerType::Rout, {rgb(0x8a8f98), 1.0F, true}},         {LayerType::Component, {rgb(0x707a88), 1.0F, false}},
    {LayerType::Mask, {rgb(0x8a6fb0), 0.6F, false}},        {LayerType::ConductivePaste, {rgb(0x9c8c7c), 1.0F, false}},
    {LayerType::Document, {rgb(0xc8c8c8), 1.0F, false}},    {LayerType::Profile, {rgb(0xe8d44d), 1.0F, false}},
    {LayerType::Other, {rgb(0x9aa0a6), 1.0F, false}},       {LayerType::ComponentBody, {rgb(0x2e3034), 1.0F, false}},
};

/// Colours of types that the palette for the colour-blind has otherwise.
constexpr std::pair<LayerType, glm::vec3> kSafeTypeColours[] = {{LayerType::SolderMask, rgb(0x2a6fa8)},
                                                                {LayerType::SilkScreen, rgb(0xffffff)},
                                                                {LayerType::Drill, rgb(0x40362c)},
                                                                {LayerType::Rout, rgb(0x75706a)},
                                                                {LayerType::Body, rgb(0x6a6450)}};

glm::vec3 colourOfType(const TypeStyle& entry, Palette palette) {
    for (const auto& [type, colour] : kSafeTypeColours) {
        if (palette == Palette::ColourBlindSafe && type == entry.type) {
            return colour;
        }
    }
    return entry.style.colour;
}

LayerStyle copperStyle(const Layer& layer, const Colours& colours, std::size_t& innerSeen) {
    switch (layer.side) {
        case LayerSide::Top: return {colours.top, 1.0F, true};
        case LayerSide::Bottom: return {colours.bottom, 1.0F, true};
        case LayerSide::Through: return {rgb(0xcfa050), 1.0F, true};
        default: return {colours.inner[innerSeen++ % colours.inner.size()], 1.0F, true};
    }
}

LayerStyle styleOfType(const Layer& layer, Palette palette) {
    const LayerType drawnAs = model::isDrawingAsSilkscreen(layer) ? LayerType::Document : layer.type;
    for (const TypeStyle& entry : kTypeStyles) {
        if (entry.type == drawnAs) {
            LayerStyle style = entry.style;
            style.colour = colourOfType(entry, palette);
            if (layer.side == LayerSide::Bottom) {
                style.colour *= palette == Palette::Standard ? 0.8F : 0.7F;
            }
            // Rows outside of the board (drawings, notes) start hidden whatever their type.
            style.isVisible = style.isVisible && layer.context == model::LayerContext::Board;
            return style;
        }
    }
    return {};
}

/// Silkscreens that are not the print of their side would cover the board.
void hideDrawings(const model::Document& document, std::vector<LayerStyle>& styles) {
    const std::vector<bool> prints = model::silkscreenPrints(document);
    for (std::size_t row = 0; row < styles.size(); ++row) {
        if (document.layers[row].type == LayerType::SilkScreen && !prints[row]) {
            styles[row].isVisible = false;
        }
    }
}

/// Boards without a body of their own (the paper's models) show their dielectrics instead.
void showSubstrates(const model::Document& document, std::vector<LayerStyle>& styles) {
    const auto isBody = [](const Layer& layer) { return layer.type == LayerType::Body; };
    const bool hasBody = std::ranges::any_of(document.layers, isBody);
    for (std::size_t row = 0; row < styles.size(); ++row) {
        if (!hasBody && document.layers[row].type == LayerType::Dielectric) {
            styles[row].isVisible = true;
        }
    }
}

/// A film of solder mask: pale ones hide more of what is under them.
struct Film {
    glm::vec3 colour;
    float opacity;
};
/// By model::BoardColour; the green one is of the palette.
constexpr Film kFilms[] = {{rgb(0x0c6e38), 0.7F},  {rgb(0xb01820), 0.7F}, {rgb(0x1438a8), 0.7F}, {rgb(0x101214), 0.93F},
                           {rgb(0xe4e4e0), 0.92F}, {rgb(0xc89808), 0.8F}, {rgb(0x641878), 0.75F}};
constexpr glm::vec3 kInks[] = {rgb(0x2e9a58), rgb(0xc83030), rgb(0x3060c8), rgb(0x18181a),
                               rgb(0xeeeedd), rgb(0xe8cc30), rgb(0x7038a8)};
constexpr glm::vec3 kTin = rgb(0xc6cacd);
constexpr glm::vec3 kBareCopper = rgb(0xc87a4c);
constexpr Film kPolyimide{rgb(0xb86a10), 0.55F};

template <class Row, std::size_t Count, class Value>
const Row& rowOf(const Row (&rows)[Count], Value value) {
    return rows[static_cast<std::size_t>(value)];
}

/// What a board is drawn as.
class SolidStyles {
public:
    SolidStyles(const model::Document& document, const Colours& colours, const model::BoardColours& chosen)
        : m_document(document), m_colours(colours), m_chosen(chosen), m_mask(rowOf(kFilms, chosen.solderMask)) {
        if (chosen.solderMask == model::BoardColour::Green) {
            m_mask.colour = colours.solderMask;
        }
    }

    void apply(const Layer& layer, LayerStyle& style) const {
        const bool isFlexible = isFlexibleFilm(m_document, layer);
        const bool isOuter = layer.side == LayerSide::Top || layer.side == LayerSide::Bottom;
        if (layer.isCopper() || layer.type == LayerType::Drill) {
            style.material = Material::Metal;
            style.colour = isOuter || layer.type == LayerType::Drill ? metal(layer.side) : style.colour;
        } else if (layer.isSynthetic && layer.type == LayerType::SolderMask) {
            const Film& film = isFlexible ? kPolyimide : m_mask;
            style = {film.colour, film.opacity, true, 0, Material::Gloss};
        } else if (layer.type == LayerType::Body) {
            style = {isFlexible ? kPolyimide.colour : m_colours.substrate, 1.0F, true};
        } else if (layer.type == LayerType::SilkScreen && !model::isDrawingAsSilkscreen(layer)) {
            style.colour = rowOf(kInks, m_chosen.silkscreen);  // on both sides alike
        }
    }

private:
    [[nodiscard]] const glm::vec3& metal(LayerSide side) const {
        const glm::vec3& gold = side == LayerSide::Bottom ? m_colours.bottomMetal : m_colours.topMetal;
        return m_chosen.finish == model::SurfaceFinish::Gold  ? gold
               : m_chosen.finish == model::SurfaceFinish::Tin ? kTin
                                                              : kBareCopper;
    }

    const model::Document& m_document;
    const Colours& m_colours;
    const model::BoardColours& m_chosen;
    Film m_mask;
};

}  // namespace

static_assert(static_cast<std::uint32_t>(Material::Matt) == shader::kMaterialMatt &&
              static_cast<std::uint32_t>(Material::Metal) == shader::kMaterialMetal &&
              static_cast<std::uint32_t>(Material::Gloss) == shader::kMaterialGloss);

std::vector<LayerStyle> defaultStyles(const model::Document& document, Appearance appearance, Palette palette) {
    return defaultStyles(document, appearance, palette, model::boardColours(document));
}

std::vector<LayerStyle> defaultStyles(const model::Document& document, Appearance appearance, Palette palette,
                                      const model::BoardColours& chosen) {
    const Colours& colours = kColours[static_cast<std::size_t>(palette)];
    std::vector<LayerStyle> styles;
    std::size_t innerSeen = 0;
    for (const Layer& layer : document.layers) {
        styles.push_back(layer.isCopper() ? copperStyle(layer, colours, innerSeen) : styleOfType(layer, palette));
    }
    hideDrawings(document, styles);
    showSubstrates(document, styles);
    const SolidStyles solid(document, colours, chosen);
    for (std::size_t row = 0; appearance == Appearance::Solid && row < styles.size(); ++row) {
        solid.apply(document.layers[row], styles[row]);
    }
    return styles;
}

}  // namespace render
