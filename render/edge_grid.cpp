#include "render/edge_grid.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

float pointDistance(glm::vec2 p, const Edge& edge) {
    const glm::vec2 d = edge.b - edge.a;
    const float length = glm::dot(d, d);
    const float t = length > 0.0F ? std::clamp(glm::dot(p - edge.a, d) / length, 0.0F, 1.0F) : 0.0F;
    return glm::length(p - edge.a - t * d);
}

float boxDistance(glm::vec2 p, glm::vec2 low, glm::vec2 high) {
    return glm::length(p - glm::clamp(p, low, high));
}

/// Does the edge have a point in the box? Slabs of x and y, one after the other.
bool meetsBox(const Edge& edge, glm::vec2 low, glm::vec2 high) {
    float from = 0.0F;
    float to = 1.0F;
    for (int axis = 0; axis < 2; ++axis) {
        const float start = edge.a[axis];
        const float way = edge.b[axis] - start;
        if (way == 0.0F) {
            if (start < low[axis] || start > high[axis]) {
                return false;
            }
            continue;
        }
        const float t0 = (low[axis] - start) / way;
        const float t1 = (high[axis] - start) / way;
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
    }
    return from <= to;
}

float edgeToBox(const Edge& edge, glm::vec2 low, glm::vec2 high) {
    if (meetsBox(edge, low, high)) {
        return 0.0F;
    }
    const glm::vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    float nearest = std::min(boxDistance(edge.a, low, high), boxDistance(edge.b, low, high));
    for (const glm::vec2& corner : corners) {
        nearest = std::min(nearest, pointDistance(corner, edge));
    }
    return nearest;
}

/// Distance of `p` from the line through the edge, positive on its left.
float side(const Edge& edge, glm::vec2 p) {
    const glm::vec2 d = edge.b - edge.a;
    const float length = glm::length(d);
    return length > 0.0F ? (d.x * (p.y - edge.a.y) - d.y * (p.x - edge.a.x)) / length : 0.0F;
}

float edgeToEdge(const Edge& e, const Edge& f) {
    if (side(e, f.a) * side(e, f.b) < 0.0F && side(f, e.a) * side(f, e.b) < 0.0F) {
        return 0.0F;
    }
    return std::min({pointDistance(e.a, f), pointDistance(e.b, f), pointDistance(f.a, e), pointDistance(f.b, e)});
}

bool isApart(float a, float b, float slack) {
    return (a > slack && b < -slack) || (a < -slack && b > slack);
}

}  // namespace

EdgeGrid::EdgeGrid(std::vector<Edge> edges) : m_edges(std::move(edges)) {
    for (const Edge& edge : m_edges) {
        m_low = glm::min(m_low, glm::min(edge.a, edge.b));
        m_high = glm::max(m_high, glm::max(edge.a, edge.b));
    }
    const glm::vec2 extent = m_edges.empty() ? glm::vec2(1.0F) : m_high - m_low;
    constexpr float kCellsPerSide = 128.0F;
    constexpr float kSmallestCell = 0.5F;  // mm: distances are asked for up to a few millimetres
    m_cell = std::max(kSmallestCell, std::max(extent.x, extent.y) / kCellsPerSide);
    m_size = glm::ivec2(extent / m_cell) + 1;
    m_cells.resize(static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y));
    m_rows.resize(static_cast<std::size_t>(m_size.y));
    for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
        const glm::ivec2 from = cellAt(glm::min(m_edges[i].a, m_edges[i].b));
        const glm::ivec2 to = cellAt(glm::max(m_edges[i].a, m_edges[i].b));
        for (int y = from.y; y <= to.y; ++y) {
            m_rows[static_cast<std::size_t>(y)].push_back(i);
            for (int x = from.x; x <= to.x; ++x) {
                m_cells[static_cast<std::size_t>(y * m_size.x + x)].push_back(i);
            }
        }
    }
}

glm::ivec2 EdgeGrid::cellAt(glm::vec2 p) const {
    const glm::vec2 cell = glm::clamp((p - m_low) / m_cell, glm::vec2(0.0F), glm::vec2(m_size - 1));
    return glm::ivec2(cell);
}

template <class Visit>
void EdgeGrid::forEdgesNear(glm::vec2 low, glm::vec2 high, const Visit& visit) const {
    const glm::ivec2 from = cellAt(low);
    const glm::ivec2 to = cellAt(high);
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            for (const std::uint32_t i : m_cells[static_cast<std::size_t>(y * m_size.x + x)]) {
                visit(m_edges[i]);
            }
        }
    }
}

float EdgeGrid::distance(glm::vec2 low, glm::vec2 high, float reach) const {
    float nearest = reach;
    forEdgesNear(low - reach, high + reach,
                 [&](const Edge& edge) { nearest = std::min(nearest, edgeToBox(edge, low, high)); });
    return nearest;
}

float EdgeGrid::distance(const Edge& line, float reach) const {
    float nearest = reach;
    forEdgesNear(glm::min(line.a, line.b) - reach, glm::max(line.a, line.b) + reach,
                 [&](const Edge& edge) { nearest = std::min(nearest, edgeToEdge(edge, line)); });
    return nearest;
}

bool EdgeGrid::contains(glm::vec2 p) const {
    if (m_edges.empty() || p.y < m_low.y || p.y > m_high.y) {
        return false;
    }
    bool isIn = false;
    for (const std::uint32_t i : m_rows[static_cast<std::size_t>(cellAt(p).y)]) {
        const auto [a, b] = m_edges[i];
        if ((a.y > p.y) != (b.y > p.y)) {
            isIn ^= p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        }
    }
    return isIn;
}

bool EdgeGrid::isCrossedBy(glm::vec2 a, glm::vec2 b, float slack) const {
    bool isCrossed = false;
    const Edge way{a, b};
    forEdgesNear(glm::min(a, b), glm::max(a, b), [&](const Edge& edge) {
        isCrossed = isCrossed || (isApart(side(edge, a), side(edge, b), slack) &&
                                  isApart(side(way, edge.a), side(way, edge.b), slack));
    });
    return isCrossed;
}

}  // namespace render
