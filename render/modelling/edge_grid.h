#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace render {

struct Edge {
    glm::vec2 a;
    glm::vec2 b;

    [[nodiscard]] float distance(glm::vec2 p) const;
    /// Does a ray from `p` to the right cross it?
    [[nodiscard]] bool isRightOf(glm::vec2 p) const;
};

/// Closed loops of edges, mm, in square cells, so that searches near a location visit few of them, and at none where
/// no edge is near.
class EdgeGrid {
public:
    explicit EdgeGrid(std::vector<Edge> edges);

    /// From a box to the nearest edge, `reach` mm at most; 0 where one crosses it.
    [[nodiscard]] float distance(glm::vec2 low, glm::vec2 high, float reach) const;
    /// The same from a straight line.
    [[nodiscard]] float distance(const Edge& line, float reach) const;
    /// Inside by the even-odd rule?
    [[nodiscard]] bool contains(glm::vec2 p) const;
    /// Does an edge properly cross the line from a to b, by more than `slack` mm on either side?
    [[nodiscard]] bool isCrossedBy(glm::vec2 a, glm::vec2 b, float slack) const;

private:
    /// Lists of edges one behind the other: list i is ids[start[i] .. start[i + 1]).
    struct Lists {
        std::vector<std::uint32_t> start;
        std::vector<std::uint32_t> ids;

        [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t list) const {
            return std::span(ids).subspan(start[list], start[list + 1] - start[list]);
        }
    };

    template <class Visit>
    void forEdgesNear(glm::vec2 low, glm::vec2 high, const Visit& visit) const;
    /// The least that `measure` gives for an edge within `reach` of the box; `reach` if that is less.
    template <class Measure>
    [[nodiscard]] float nearest(glm::vec2 low, glm::vec2 high, float reach, const Measure& measure) const;
    /// `forLists(edge, add)` calls add(list) for every list that the edge is in.
    template <class ForLists>
    [[nodiscard]] Lists sortInto(std::size_t count, const ForLists& forLists) const;
    void measureClearance();
    void markInside();
    [[nodiscard]] bool isFarFrom(glm::vec2 low, glm::vec2 high, float reach) const;
    [[nodiscard]] bool crossesOddly(glm::vec2 p) const;
    [[nodiscard]] glm::ivec2 cellAt(glm::vec2 p) const;
    [[nodiscard]] std::size_t rowOf(glm::ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(m_size.x) + static_cast<std::size_t>(cell.x);
    }

    std::vector<Edge> m_edges;
    glm::vec2 m_low{1e30F};
    glm::vec2 m_high{-1e30F};
    glm::ivec2 m_size{1};
    float m_cell = 1.0F;
    Lists m_cells;                          ///< by y * size.x + x: edges whose box meets the cell
    Lists m_rows;                           ///< by y
    std::vector<std::uint8_t> m_clearance;  ///< by cell: steps to the nearest one with edges, diagonal ones included
    std::vector<std::uint8_t> m_isInside;   ///< by cell without edges
};

}  // namespace render
