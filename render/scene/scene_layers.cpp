#include "render/scene/scene_layers.h"

#include <algorithm>
#include <cmath>

#include "render/scene/body_colours.h"
#include "render/scene/element_state.h"
#include "render/scene/z_scale.h"
#include "shaders/shared/board.h"

namespace render {

namespace {

std::vector<StackedLayer> stackupOf(const SceneLayers& scene, const ZScale& scale) {
    const std::vector<ZRange> heights = scaleHeights(scene.layers, scale);
    std::vector<StackedLayer> stackup;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        stackup.push_back({heights[i], scene.styles[i].isVisible, !scene.layers[i].hasAreas});
    }
    return stackup;
}

/// Between a raised layer and the next, mm: more than the thinnest layer has.
constexpr float kRaise = 0.02F;

/// A raised layer reaches beyond the others on both sides: drawn flat, only its faces are seen.
void raise(const std::vector<LayerStyle>& styles, std::vector<ZRange>& heights) {
    ZRange all{0.0F, 0.0F};
    for (const ZRange& z : heights) {
        all = {std::min(all.z0, z.z0), std::max(all.z1, z.z1)};
    }
    for (std::size_t row = 0; row < heights.size(); ++row) {
        if (styles[row].raised > 0) {
            const float by = kRaise * static_cast<float>(styles[row].raised);
            heights[row] = {all.z0 - by, all.z1 + by};
        }
    }
}

}  // namespace

SceneLayers::SceneLayers(const BoardFrame& frame)
    : layers(frame.layers),
      styles(frame.layers.size()),
      widthMm(std::max(frame.boxMax.x - frame.boxMin.x, frame.boxMax.y - frame.boxMin.y)),
      facesMm(frame.facesMm),
      hasFlipped(std::ranges::any_of(frame.copies, &ModelCopy::isFlipped)) {}

glm::vec3 toLinear(const glm::vec3& srgb) {
    const auto linear = [](float part) {
        return part <= 0.04045F ? part / 12.92F : std::pow((part + 0.055F) / 1.055F, 2.4F);
    };
    return {linear(srgb.r), linear(srgb.g), linear(srgb.b)};
}

ElementColours paletteOf(std::span<const glm::vec3> colours) {
    ElementColours palette{};
    std::ranges::transform(colours, palette.begin(), toLinear);
    std::ranges::transform(kHighlightColours, palette.begin() + shader::kHighlightRow, toLinear);
    std::ranges::transform(kBodyColours, palette.begin() + shader::kMaterialRow, toLinear);
    return palette;
}

std::vector<ZRange> drawnHeights(const SceneLayers& scene, const ViewSettings& settings) {
    std::vector<ZRange> heights =
        explode(stackupOf(scene, settings.zScale), settings.explode * kFullSpread * scene.widthMm);
    if (settings.is2d) {
        raise(scene.styles, heights);
    }
    return heights;
}

Box3 withBodies(Box3 box, const SceneLayers& scene, const ViewSettings& settings) {
    const std::vector<ZRange> heights = drawnHeights(scene, settings);
    for (std::size_t row = 0; row < heights.size(); ++row) {
        const FrameLayer& layer = scene.layers[row];
        const float tallest = layer.z1 - layer.z0;
        if (!scene.styles[row].isVisible || layer.growth == 0) {
            continue;
        }
        if (layer.growth == shader::kLayerGrowsDown) {
            box.min.z = std::min(box.min.z, heights[row].z1 - tallest);
        } else {
            box.max.z = std::max(box.max.z, heights[row].z0 + tallest);
        }
    }
    return box;
}

/// Explosion moves layers apart from the middle: of two at mirror images one by as much up as the other down.
float drawnFaces(const SceneLayers& scene, const ViewSettings& settings) {
    std::vector<FrameLayer> layers = scene.layers;
    layers.push_back({scene.facesMm.x, scene.facesMm.y});
    const ZRange faces = scaleHeights(layers, settings.zScale).back();
    return faces.z0 + faces.z1;
}

}  // namespace render
