#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/modelling/board_model.h"

namespace render {

/// The outlines of a model's shapes, holes among them, as chains of edges: what the triangles of a shape cover lies
/// inside, counter-clockwise around it. A shape that is cut into pieces (area_pieces.h) has them at its first piece.
class AreaOutlines {
public:
    /// Edges from point to point; the shape's millimetres. Chains of a shape make closed lines together.
    struct Chain {
        std::uint32_t firstPoint = 0;
        std::uint32_t pointCount = 0;
        Box2 box;
    };

    explicit AreaOutlines(const BoardModel& model);

    /// None of a piece that is not its shape's first.
    [[nodiscard]] std::span<const Chain> chainsOf(std::uint32_t shape) const {
        const LayerRun run = m_chainsOfShape[shape];
        return {m_chains.data() + run.first, run.count};
    }
    [[nodiscard]] std::span<const glm::vec2> pointsOf(const Chain& chain) const {
        return {m_points.data() + chain.firstPoint, chain.pointCount};
    }

private:
    std::vector<glm::vec2> m_points;
    std::vector<Chain> m_chains;
    std::vector<LayerRun> m_chainsOfShape;
};

}  // namespace render
