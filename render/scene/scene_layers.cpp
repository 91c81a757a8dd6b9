#include "render/scene/scene_layers.h"

#include <cmath>

#include "render/scene/z_scale.h"

namespace render {

namespace {

std::vector<StackedLayer> stackOf(const SceneLayers& scene, const ZScale& scale) {
    std::vector<ScaledLayer> layers;
    for (const SceneLayers::Layer& layer : scene.layers) {
        layers.push_back({{layer.z0, layer.z1}, layer.isCopper});
    }
    const std::vector<ZRange> heights = scaleHeights(layers, scale);
    std::vector<StackedLayer> stack;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        stack.push_back({heights[i], scene.styles[i].isVisible, !scene.layers[i].hasAreas});
    }
    return stack;
}

}  // namespace

glm::vec3 toLinear(const glm::vec3& srgb) {
    const auto light = [](float part) {
        return part <= 0.04045F ? part / 12.92F : std::pow((part + 0.055F) / 1.055F, 2.4F);
    };
    return {light(srgb.r), light(srgb.g), light(srgb.b)};
}

std::vector<ZRange> drawnHeights(const SceneLayers& scene, const ViewSettings& settings) {
    return explode(stackOf(scene, settings.zScale), settings.explode * kFullSpread * scene.widthMm);
}

}  // namespace render
