#include "render/modelling/edge_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace render {
namespace {

float boxDistance(glm::vec2 p, glm::vec2 low, glm::vec2 high) {
    return glm::length(p - glm::clamp(p, low, high));
}

/// Does the edge have a point in the box? Slabs of x and y, one after the other.
bool meetsBox(const Edge& edge, glm::vec2 low, glm::vec2 high) {
    float from = 0.0F;
    float to = 1.0F;
    for (int axis = 0; axis < 2; ++axis) {
        const float start = edge.a[axis];
        const float extent = edge.b[axis] - start;
        if (extent == 0.0F) {
            if (start < low[axis] || start > high[axis]) {
                return false;
            }
            continue;
        }
        const float t0 = (low[axis] - start) / extent;
        const float t1 = (high[axis] - start) / extent;
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
        nearest = std::min(nearest, edge.distance(corner));
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
    return std::min({f.distance(e.a), f.distance(e.b), e.distance(f.a), e.distance(f.b)});
}

bool isApart(float a, float b, float slack) {
    return (a > slack && b < -slack) || (a < -slack && b > slack);
}

}  // namespace

float Edge::distance(glm::vec2 p) const {
    const glm::vec2 d = b - a;
    const float length = glm::dot(d, d);
    const float t = length > 0.0F ? std::clamp(glm::dot(p - a, d) / length, 0.0F, 1.0F) : 0.0F;
    return glm::length(p - a - t * d);
}

bool Edge::isRightOf(glm::vec2 p) const {
    return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
}

EdgeGrid::EdgeGrid(std::vector<Edge> edges) : m_edges(std::move(edges)) {
    for (const Edge& edge : m_edges) {
        m_low = glm::min(m_low, glm::min(edge.a, edge.b));
        m_high = glm::max(m_high, glm::max(edge.a, edge.b));
    }
    const glm::vec2 extent = m_edges.empty() ? glm::vec2(1.0F) : m_high - m_low;
    constexpr float kCellsPerSide = 128.0F;
    constexpr float kSmallestCell = 0.5F;  // mm: distances are requested up to a few millimetres
    m_cell = std::max(kSmallestCell, std::max(extent.x, extent.y) / kCellsPerSide);
    m_size = glm::ivec2(extent / m_cell) + 1;
    const auto rows = static_cast<std::size_t>(m_size.y);
    m_rows = sortInto(rows, [this](const Edge& edge, const auto& add) {
        const int last = cellAt(glm::max(edge.a, edge.b)).y;
        for (int y = cellAt(glm::min(edge.a, edge.b)).y; y <= last; ++y) {
            add(static_cast<std::size_t>(y));
        }
    });
    m_cells = sortInto(rows * static_cast<std::size_t>(m_size.x), [this](const Edge& edge, const auto& add) {
        const glm::ivec2 from = cellAt(glm::min(edge.a, edge.b));
        const glm::ivec2 to = cellAt(glm::max(edge.a, edge.b));
        for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) {
                add(rowOf({x, y}));
            }
        }
    });
    measureClearance();
    markInside();
}

template <class ForLists>
EdgeGrid::Lists EdgeGrid::sortInto(std::size_t count, const ForLists& forLists) const {
    Lists lists;
    lists.start.assign(count + 1, 0);
    for (const Edge& edge : m_edges) {
        forLists(edge, [&](std::size_t list) { ++lists.start[list + 1]; });
    }
    std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
    lists.ids.resize(lists.start.back());
    std::vector<std::uint32_t> next(lists.start.begin(), lists.start.end() - 1);
    for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
        forLists(m_edges[i], [&](std::size_t list) { lists.ids[next[list]++] = i; });
    }
    return lists;
}

/// Once forward, once backward: each cell is a step farther than its nearest neighbour.
void EdgeGrid::measureClearance() {
    constexpr int kMost = 255;
    m_clearance.resize(m_cells.start.size() - 1);
    for (std::size_t i = 0; i < m_clearance.size(); ++i) {
        m_clearance[i] = m_cells[i].empty() ? kMost : 0;
    }
    const auto approach = [this](glm::ivec2 cell, glm::ivec2 step) {
        const glm::ivec2 other = cell + step;
        if (other.x >= 0 && other.y >= 0 && other.x < m_size.x && other.y < m_size.y) {
            std::uint8_t& own = m_clearance[rowOf(cell)];
            own = static_cast<std::uint8_t>(std::min<int>(own, m_clearance[rowOf(other)] + 1));
        }
    };
    constexpr glm::ivec2 kBefore[] = {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    for (int i = 0; i < m_size.x * m_size.y; ++i) {
        std::ranges::for_each(kBefore, [&](glm::ivec2 step) { approach({i % m_size.x, i / m_size.x}, step); });
    }
    for (int i = m_size.x * m_size.y - 1; i >= 0; --i) {
        std::ranges::for_each(kBefore, [&](glm::ivec2 step) { approach({i % m_size.x, i / m_size.x}, -step); });
    }
}

/// Cells without edges are inside or outside as a whole, and neighbours among them alike.
void EdgeGrid::markInside() {
    m_isInside.assign(m_clearance.size(), 0);
    for (int y = 0; y < m_size.y; ++y) {
        for (int x = 0; x < m_size.x; ++x) {
            const std::size_t cell = rowOf({x, y});
            if (m_clearance[cell] == 0) {
                continue;
            }
            if (x > 0 && m_clearance[cell - 1] > 0) {
                m_isInside[cell] = m_isInside[cell - 1];
            } else if (y > 0 && m_clearance[rowOf({x, y - 1})] > 0) {
                m_isInside[cell] = m_isInside[rowOf({x, y - 1})];
            } else {
                m_isInside[cell] = crossesOddly(m_low + m_cell * (glm::vec2(x, y) + 0.5F)) ? 1 : 0;
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
            for (const std::uint32_t i : m_cells[rowOf({x, y})]) {
                visit(m_edges[i]);
            }
        }
    }
}

/// Is every edge `reach` or more from the box for sure, by the clearance around its middle?
bool EdgeGrid::isFarFrom(glm::vec2 low, glm::vec2 high, float reach) const {
    const glm::vec2 middle = 0.5F * (low + high);
    if (glm::any(glm::lessThan(middle, m_low)) || glm::any(glm::greaterThan(middle, m_high))) {
        return false;
    }
    const auto steps = static_cast<float>(m_clearance[rowOf(cellAt(middle))]);
    // Between a location in a cell and an edge n steps away lie n - 1 whole cells; a little less for rounding.
    return (steps - 1.01F) * m_cell >= reach + 0.5F * glm::length(high - low);
}

template <class Measure>
float EdgeGrid::nearest(glm::vec2 low, glm::vec2 high, float reach, const Measure& measure) const {
    float least = reach;
    if (!isFarFrom(low, high, reach)) {
        forEdgesNear(low - reach, high + reach, [&](const Edge& edge) { least = std::min(least, measure(edge)); });
    }
    return least;
}

float EdgeGrid::distance(glm::vec2 low, glm::vec2 high, float reach) const {
    return nearest(low, high, reach, [&](const Edge& edge) { return edgeToBox(edge, low, high); });
}

float EdgeGrid::distance(const Edge& line, float reach) const {
    return nearest(glm::min(line.a, line.b), glm::max(line.a, line.b), reach,
                   [&](const Edge& edge) { return edgeToEdge(edge, line); });
}

bool EdgeGrid::contains(glm::vec2 p) const {
    if (m_edges.empty() || glm::any(glm::lessThan(p, m_low)) || glm::any(glm::greaterThan(p, m_high))) {
        return false;
    }
    const std::size_t cell = rowOf(cellAt(p));
    return m_clearance[cell] > 0 ? m_isInside[cell] != 0 : crossesOddly(p);
}

/// Does a ray to the right cross an odd number of edges?
bool EdgeGrid::crossesOddly(glm::vec2 p) const {
    const auto isRight = [&](std::uint32_t i) { return m_edges[i].isRightOf(p); };
    return std::ranges::count_if(m_rows[static_cast<std::size_t>(cellAt(p).y)], isRight) % 2 != 0;
}

bool EdgeGrid::isCrossedBy(glm::vec2 a, glm::vec2 b, float slack) const {
    bool isCrossed = false;
    const Edge extent{a, b};
    forEdgesNear(glm::min(a, b), glm::max(a, b), [&](const Edge& edge) {
        isCrossed = isCrossed || (isApart(side(edge, a), side(edge, b), slack) &&
                                  isApart(side(extent, edge.a), side(extent, edge.b), slack));
    });
    return isCrossed;
}

}  // namespace render
