#pragma once

#include <numbers>
#include <vector>

#include "render/modelling/board_model.h"
#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"

namespace render::test {

/// Builds small board models by hand, so that what the renderer does can be told from what the readers do.
class SyntheticBoard {
public:
    /// Layers get ids in the order they are added; lets and areas that follow belong to the last one.
    void addLayer(float z0, float z1, const glm::vec3& colour, float opacity = 1.0F);
    /// Each returns its element's number.
    std::uint32_t addTrack(glm::vec2 a, glm::vec2 b, float radius, float innerRadius = 0.0F, std::uint32_t flags = 0);
    std::uint32_t addDisc(glm::vec2 centre, float radius, float innerRadius = 0.0F, std::uint32_t flags = 0);
    std::uint32_t addArc(glm::vec2 centre, float arcRadius, float start, float sweep, float penRadius);
    /// The cell around a round hole, its sides turned counter-clockwise.
    std::uint32_t addHole(glm::vec2 centre, float radius, float cell, float turn = 0.0F);
    /// One shape placed once or more; loops in micrometres, the outline first, counter-clockwise, holes clockwise.
    std::uint32_t addArea(const std::vector<std::vector<base::Point>>& loops,
                          const std::vector<shader::AreaInstance>& locations);

    [[nodiscard]] BoardModel build() const;
    [[nodiscard]] const std::vector<LayerStyle>& styles() const { return m_styles; }

private:
    std::uint32_t addLet(shader::Let let);

    std::vector<std::vector<shader::Let>> m_lets;       ///< by layer
    std::vector<std::vector<std::uint32_t>> m_batches;  ///< by layer, rows of m_model.areaBatches
    std::vector<LayerStyle> m_styles;
    BoardModel m_model;
    std::uint32_t m_elements = 0;
};

/// Every kind of let, tubes, square pens, bores, areas with holes, mirrored pads and translucent layers, on about 40 x
/// 30 mm.
[[nodiscard]] SyntheticBoard everything();

/// `count` random strokes, discs and rings on one layer of 100 x 60 mm.
[[nodiscard]] SyntheticBoard randomTraces(int count, std::uint32_t seed);

/// Pixels whose largest difference in red, green or blue exceeds `threshold`.
[[nodiscard]] std::size_t differingPixels(const Image& a, const Image& b, int threshold = 8);
/// Pixels brighter than half, of a mono picture.
[[nodiscard]] std::size_t whitePixels(const Image& image);

}  // namespace render::test
