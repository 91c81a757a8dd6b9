#include "render/scene/z_scale.h"

#include <algorithm>

namespace render {
namespace {

/// A piecewise linear function of height.
class Stretch {
public:
    Stretch(std::span<const FrameLayer> layers, const ZScale& scale) {
        m_from.push_back(0.0F);
        for (const FrameLayer& layer : layers) {
            m_from.insert(m_from.end(), {layer.z0, layer.z1});
        }
        std::ranges::sort(m_from);
        m_from.erase(std::unique(m_from.begin(), m_from.end()), m_from.end());
        float to = 0.0F;
        for (std::size_t i = 0; i < m_from.size(); ++i) {
            const float factor = i > 0 && isCopper(layers, m_from[i - 1], m_from[i]) ? scale.copper : scale.dielectric;
            to += i > 0 ? factor * (m_from[i] - m_from[i - 1]) : 0.0F;
            m_to.push_back(to);
        }
        const float origin = at(0.0F);
        for (float& height : m_to) {
            height -= origin;
        }
    }

    /// Of a height that was given.
    [[nodiscard]] float at(float z) const {
        return m_to[static_cast<std::size_t>(std::ranges::lower_bound(m_from, z) - m_from.begin())];
    }

private:
    static bool isCopper(std::span<const FrameLayer> layers, float low, float high) {
        return std::ranges::any_of(
            layers, [&](const FrameLayer& layer) { return layer.isCopper && layer.z0 <= low && high <= layer.z1; });
    }

    std::vector<float> m_from;  ///< rising
    std::vector<float> m_to;
};

}  // namespace

std::vector<ZRange> scaleHeights(std::span<const FrameLayer> layers, const ZScale& scale) {
    std::vector<ZRange> heights;
    const bool isReal = scale == ZScale{};
    const Stretch stretch(isReal ? std::span<const FrameLayer>() : layers, scale);
    for (const FrameLayer& layer : layers) {
        heights.push_back(isReal ? ZRange{layer.z0, layer.z1} : ZRange{stretch.at(layer.z0), stretch.at(layer.z1)});
    }
    return heights;
}

Box3 scaledBox(const BoardFrame& board, const ZScale& scale) {
    std::vector<FrameLayer> layers = board.layers;
    layers.push_back({board.boxMin.z, board.boxMax.z});
    const ZRange whole = scaleHeights(layers, scale).back();
    return {{board.boxMin.x, board.boxMin.y, whole.z0}, {board.boxMax.x, board.boxMax.y, whole.z1}};
}

}  // namespace render
