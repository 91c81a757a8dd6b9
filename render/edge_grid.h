#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace render {

struct Edge {
    glm::vec2 a;
    glm::vec2 b;
};

/// Closed loops of edges, mm, in square cells, so that questions about a place look at few of them.
class EdgeGrid {
public:
    explicit EdgeGrid(std::vector<Edge> edges);

    /// From a box to the nearest edge, `reach` mm at most; 0 where one crosses it.
    [[nodiscard]] float distance(glm::vec2 low, glm::vec2 high, float reach) const;
    /// The same from a straight line.
    [[nodiscard]] float distance(const Edge& line, float reach) const;
    /// Inside by the even-odd rule?
    [[nodiscard]] bool contains(glm::vec2 p) const;
    /// Does an edge properly cross the way from a to b, by more than `slack` mm on either side?
    [[nodiscard]] bool isCrossedBy(glm::vec2 a, glm::vec2 b, float slack) const;

private:
    template <class Visit>
    void forEdgesNear(glm::vec2 low, glm::vec2 high, const Visit& visit) const;
    [[nodiscard]] glm::ivec2 cellAt(glm::vec2 p) const;

    std::vector<Edge> m_edges;
    glm::vec2 m_low{1e30F};
    glm::vec2 m_high{-1e30F};
    glm::ivec2 m_size{1};
    float m_cell = 1.0F;
    std::vector<std::vector<std::uint32_t>> m_cells;  ///< by y * size.x + x: edges whose box meets the cell
    std::vector<std::vector<std::uint32_t>> m_rows;   ///< by y
};

}  // namespace render
