#include "render/scene/explosion.h"

#include <algorithm>

namespace render {
namespace {

float middle(const ZRange& z) {
    return 0.5F * (z.z0 + z.z1);
}

bool spans(const StackedLayer& outer, const StackedLayer& inner) {
    const float outerThickness = outer.z.z1 - outer.z.z0;
    const float innerThickness = inner.z.z1 - inner.z.z0;
    return inner.isVisible && outerThickness > innerThickness && outer.z.z0 <= inner.z.z0 && inner.z.z1 <= outer.z.z1;
}

bool isStretched(std::span<const StackedLayer> layers, const StackedLayer& layer) {
    return layer.isBarrels &&
           std::any_of(layers.begin(), layers.end(), [&](const StackedLayer& other) { return spans(layer, other); });
}

/// Heights of the layers that are moved as a whole, each once, rising.
std::vector<float> floorsOf(std::span<const StackedLayer> layers, std::span<const std::uint8_t> stretched) {
    std::vector<float> floors;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].isVisible && stretched[i] == 0) {
            floors.push_back(middle(layers[i].z));
        }
    }
    std::sort(floors.begin(), floors.end());
    floors.erase(std::unique(floors.begin(), floors.end()), floors.end());
    return floors;
}

/// -spread / 2 for the lowest floor to spread / 2 for the highest.
float offsetAt(float height, std::span<const float> floors, float spread) {
    if (floors.size() < 2) {
        return 0.0F;
    }
    const auto floor = std::lower_bound(floors.begin(), floors.end(), height);
    const auto rank = static_cast<float>(
        std::min<std::ptrdiff_t>(floor - floors.begin(), static_cast<std::ptrdiff_t>(floors.size()) - 1));
    return spread * (rank / static_cast<float>(floors.size() - 1) - 0.5F);
}

ZRange stretch(std::span<const StackedLayer> layers, const StackedLayer& layer, std::span<const float> floors,
               float spread) {
    float lowest = layer.z.z1;
    float highest = layer.z.z0;
    for (const StackedLayer& other : layers) {
        if (spans(layer, other)) {
            lowest = std::min(lowest, middle(other.z));
            highest = std::max(highest, middle(other.z));
        }
    }
    return {layer.z.z0 + offsetAt(lowest, floors, spread), layer.z.z1 + offsetAt(highest, floors, spread)};
}

}  // namespace

std::vector<ZRange> explode(std::span<const StackedLayer> layers, float spread) {
    std::vector<std::uint8_t> stretched(layers.size());
    std::transform(layers.begin(), layers.end(), stretched.begin(), [&](const StackedLayer& layer) {
        return isStretched(layers, layer) ? std::uint8_t{1} : std::uint8_t{0};
    });
    const std::vector<float> floors = floorsOf(layers, stretched);
    std::vector<ZRange> result;
    result.reserve(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const ZRange z = layers[i].z;
        const float offset = offsetAt(middle(z), floors, spread);
        result.push_back(stretched[i] != 0 ? stretch(layers, layers[i], floors, spread)
                                           : ZRange{z.z0 + offset, z.z1 + offset});
    }
    return result;
}

Box3 explodedBox(const Box3& board, float explode) {
    const float spread = kFullSpread * explode * std::max(board.max.x - board.min.x, board.max.y - board.min.y);
    const glm::vec3 margin(0.0F, 0.0F, spread / 2.0F);
    return {board.min - margin, board.max + margin};
}

}  // namespace render
