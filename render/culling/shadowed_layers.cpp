#include "render/culling/shadowed_layers.h"

#include <algorithm>

namespace render {
namespace {

/// Under a body.
constexpr float kStrength = 0.65F;
/// ViewSettings::explode at which shadows are gone: what is apart casts none.
constexpr float kApart = 0.04F;
constexpr std::uint32_t kShadowed = shader::kMaterialShadowed << shader::kLayerMaterialShift;
/// Heights that are sums of the same layers may differ by so much, mm.
constexpr float kRounding = 1e-4F;

bool areBodiesShown(const SceneLayers& scene, bool isFromAbove) {
    const std::uint32_t growth = isFromAbove ? shader::kLayerGrowsUp : shader::kLayerGrowsDown;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const LayerStyle& style = scene.styles[i];
        if (scene.layers[i].growth == growth && style.isVisible && style.opacity >= 1.0F) {
            return true;
        }
    }
    return false;
}

float strengthOf(const SceneLayers& scene, const ViewSettings& settings, bool isFromAbove) {
    const bool isShaded = !settings.is2d && !settings.isMono && !settings.isOutlined;
    if (!scene.hasShadows || !isShaded || !areBodiesShown(scene, isFromAbove)) {
        return 0.0F;
    }
    const float together = 1.0F - std::min(settings.explode / kApart, 1.0F);
    return kStrength * together * (1.0F - std::clamp(settings.dim, 0.0F, 1.0F));
}

/// The inner face of the outermost copper that does not lie beyond `limit`. Heights are away from the middle of the
/// board.
float innerFaceBelow(const SceneLayers& scene, bool isFromAbove, float limit) {
    float height = -1e30F;
    float inner = -1e30F;
    for (const FrameLayer& layer : scene.layers) {
        const float outer = isFromAbove ? layer.z1 : -layer.z0;
        if (layer.isCopper && outer > height && outer <= limit + kRounding) {
            height = outer;
            inner = isFromAbove ? layer.z0 : -layer.z1;
        }
    }
    return inner;
}

/// What reaches as far as the inner face of the outermost copper has a face outside: the dielectric under it too. Where
/// bodies stand on copper further inside (rigid-flex), that is the outermost there.
float outsideOf(const SceneLayers& scene, bool isFromAbove) {
    float inner = innerFaceBelow(scene, isFromAbove, 1e30F);
    const std::uint32_t growth = isFromAbove ? shader::kLayerGrowsUp : shader::kLayerGrowsDown;
    for (const FrameLayer& layer : scene.layers) {
        const float base = isFromAbove ? layer.z0 : -layer.z1;
        const float below = layer.growth == growth ? innerFaceBelow(scene, isFromAbove, base) : inner;
        inner = below > -1e30F ? std::min(inner, below) : inner;
    }
    return isFromAbove ? inner - kRounding : kRounding - inner;
}

}  // namespace

ShadowedLayers::ShadowedLayers(const SceneLayers& scene, const ViewSettings& settings, bool isFromAbove)
    : m_scene(scene),
      m_isFromAbove(isFromAbove),
      m_strength(strengthOf(scene, settings, isFromAbove)),
      m_outside(outsideOf(scene, isFromAbove)) {}

bool ShadowedLayers::reachesOut(const ZRange& z) const {
    return m_isFromAbove ? z.z1 >= m_outside : z.z0 <= m_outside;
}

void ShadowedLayers::set(bool isShadowed, shader::LayerState& state) const {
    state.flags = isShadowed && m_strength > 0.0F ? state.flags | kShadowed : state.flags & ~kShadowed;
}

void ShadowedLayers::mark(std::span<shader::LayerState> states) const {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const FrameLayer& layer = m_scene.layers[i];
        set(layer.growth == 0 && reachesOut({layer.z0, layer.z1}), states[i]);
    }
}

void ShadowedLayers::markMirrored(std::uint32_t layer, shader::LayerState& state) const {
    const FrameLayer& own = m_scene.layers[layer];
    const float faces = m_scene.facesMm.x + m_scene.facesMm.y;
    set(own.growth == 0 && reachesOut({faces - own.z1, faces - own.z0}), state);
}

}  // namespace render
