#include "model/figures/distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace model {

namespace {

/// A lower bound of the spacing between what two boxes hold. Boxes are rounded outwards, so it is never too large.
double apart(const Box& a, const Box& b) {
    const double dx = std::max({double{0}, double(b.min.x) - a.max.x, double(a.min.x) - b.max.x});
    const double dy = std::max({double{0}, double(b.min.y) - a.max.y, double(a.min.y) - b.max.y});
    return std::sqrt(dx * dx + dy * dy);
}

constexpr std::size_t kMaxLevels = 12;  // 8^11 edges are more than 32 bits can count

/// The levels of a figure's boxes, from the finest to the one that holds everything.
struct Levels {
    std::span<const Edge> edges;
    std::span<const Box> boxes;
    std::array<std::size_t, kMaxLevels> first{};
    std::array<std::size_t, kMaxLevels> count{};
    std::size_t top = 0;

    Levels(const FigureTable& table, std::size_t row) : edges(table.edges(row)), boxes(table.boxes(row)) {
        std::size_t size = (edges.size() + FigureTable::kBranch - 1) / FigureTable::kBranch;
        count[0] = size;
        while (size > 1) {
            first[top + 1] = first[top] + size;
            size = (size + FigureTable::kBranch - 1) / FigureTable::kBranch;
            count[++top] = size;
        }
    }
    [[nodiscard]] const Box& box(std::size_t level, std::size_t index) const { return boxes[first[level] + index]; }
    /// Rows of level - 1 below a box; rows of `edges` on level 0.
    [[nodiscard]] std::pair<std::size_t, std::size_t> children(std::size_t level, std::size_t index) const {
        const std::size_t all = level == 0 ? edges.size() : count[level - 1];
        return {index * FigureTable::kBranch, std::min((index + 1) * FigureTable::kBranch, all)};
    }
};

/// Searches two trees of boxes at once for the closest pair of edges.
class ClosestEdges {
public:
    ClosestEdges(const Levels& a, const Levels& b, double limit) : m_a(a), m_b(b), m_limit(limit) {}

    std::optional<Spacing> find() {
        descend(m_a.top, 0, m_b.top, 0);
        return m_best;
    }

private:
    void descend(std::size_t levelA, std::size_t a, std::size_t levelB, std::size_t b) {
        if (isDone() || apart(m_a.box(levelA, a), m_b.box(levelB, b)) > m_limit) {
            return;
        }
        if (levelA == 0 && levelB == 0) {
            return compare(a, b);
        }
        if (levelA >= levelB) {
            const auto [first, end] = m_a.children(levelA, a);
            for (std::size_t i = first; i < end; ++i) {
                descend(levelA - 1, i, levelB, b);
            }
        } else {
            const auto [first, end] = m_b.children(levelB, b);
            for (std::size_t i = first; i < end; ++i) {
                descend(levelA, a, levelB - 1, i);
            }
        }
    }

    void compare(std::size_t a, std::size_t b) {
        const auto [firstA, endA] = m_a.children(0, a);
        const auto [firstB, endB] = m_b.children(0, b);
        // Few edges fill their group: one from side to side of a board makes the box of its group as large.
        std::array<Box, FigureTable::kBranch> boxesOfB;
        std::transform(&m_b.edges[firstB], &m_b.edges[firstB] + (endB - firstB), boxesOfB.begin(), boxOf);
        for (std::size_t i = firstA; i < endA; ++i) {
            const Box boxOfA = boxOf(m_a.edges[i]);
            if (apart(boxOfA, m_b.box(0, b)) > m_limit) {
                continue;
            }
            for (std::size_t j = firstB; j < endB && !isDone(); ++j) {
                if (apart(boxOfA, boxesOfB[j - firstB]) > m_limit) {
                    continue;
                }
                const Spacing spacing = spacingBetween(m_a.edges[i], m_b.edges[j]);
                if (spacing.distance <= m_limit) {
                    m_best = spacing;
                    m_limit = spacing.distance;
                }
            }
        }
    }

    [[nodiscard]] bool isDone() const { return m_best && m_best->distance <= 0; }

    const Levels& m_a;
    const Levels& m_b;
    double m_limit;
    std::optional<Spacing> m_best;
};

/// Winding numbers of the island and of the holes around a point, over the edges a ray to the right may meet.
class RayToTheRight {
public:
    RayToTheRight(const Levels& levels, PointD p) : m_levels(levels), m_p(p) { descend(levels.top, 0); }

    [[nodiscard]] bool isInside() const { return m_island > 0 && m_holes <= 0; }

private:
    void descend(std::size_t level, std::size_t index) {
        const Box& box = m_levels.box(level, index);
        if (box.max.x < m_p.x || box.min.y > m_p.y || box.max.y < m_p.y) {
            return;
        }
        const auto [first, end] = m_levels.children(level, index);
        for (std::size_t i = first; i < end; ++i) {
            level > 0 ? descend(level - 1, i) : count(m_levels.edges[i]);
        }
    }

    void count(const Edge& edge) { (edge.isHole ? m_holes : m_island) += edge.winding * windingAround(edge, m_p); }

    const Levels& m_levels;
    PointD m_p;
    int m_island = 0;
    int m_holes = 0;
};

void descend(const Levels& levels, std::size_t level, std::size_t index, const Box& box,
             const std::function<void(const Edge&)>& visit) {
    if (apart(levels.box(level, index), box) > 0) {
        return;
    }
    const auto [first, end] = levels.children(level, index);
    for (std::size_t i = first; i < end; ++i) {
        level > 0 ? descend(levels, level - 1, i, box, visit) : visit(levels.edges[i]);
    }
}

/// The shortest line from a point to the edges below a box, or `best` if that is shorter. Looks no further than one
/// that is no longer than `enough`.
Spacing nearest(const Levels& levels, std::size_t level, std::size_t index, const Edge& dot, Spacing best,
                double enough) {
    if (best.distance <= enough || apart(levels.box(level, index), boxOf(dot)) >= best.distance) {
        return best;
    }
    const auto [first, end] = levels.children(level, index);
    for (std::size_t i = first; i < end; ++i) {
        if (level > 0) {
            best = nearest(levels, level - 1, i, dot, best, enough);
        } else {
            Edge edge = levels.edges[i];
            edge.pen = 0;
            const Spacing spacing = spacingBetween(dot, edge);
            best = spacing.distance < best.distance ? spacing : best;
        }
    }
    return best;
}

/// The length of a short line between two figures: from a point to what is nearest to it on one, from there to the
/// other, and so on. A search for the shortest that begins with it looks at little else.
double lengthOfShortLine(const Levels& a, const Levels& b, PointD from) {
    constexpr int kSteps = 4;
    Spacing line;
    Edge dot;
    dot.a = dot.b = from;
    for (int step = 0; step < kSteps; ++step) {
        const Levels& to = step % 2 == 0 ? a : b;
        line = nearest(to, to.top, 0, dot, {std::numeric_limits<double>::infinity(), from, from}, 0.0);
        dot.a = dot.b = line.to;
    }
    return line.distance;
}

}  // namespace

bool isInside(const FigureTable& table, std::size_t row, PointD p) {
    return table[row].isFilled && RayToTheRight(Levels(table, row), p).isInside();
}

Spacing spacingToEdges(const FigureTable& table, std::size_t row, PointD p, double enough) {
    Edge dot;
    dot.a = dot.b = p;
    const Levels levels(table, row);
    // Boxes hold pens and are rounded outwards, so they never cut a nearer edge off.
    return nearest(levels, levels.top, 0, dot, {std::numeric_limits<double>::infinity(), p, p}, enough);
}

void visitEdges(const FigureTable& table, std::size_t row, const Box& box,
                const std::function<void(const Edge&)>& visit) {
    const Levels levels(table, row);
    descend(levels, levels.top, 0, box, visit);
}

std::optional<Spacing> spacingBetween(const FigureTable& a, std::size_t rowA, const FigureTable& b, std::size_t rowB,
                                      double limit) {
    if (apart(a.box(rowA), b.box(rowB)) > limit) {
        return std::nullopt;
    }
    const std::optional<PointD> common = isInside(b, rowB, a[rowA].anchor)   ? std::optional(a[rowA].anchor)
                                         : isInside(a, rowA, b[rowB].anchor) ? std::optional(b[rowB].anchor)
                                                                             : std::nullopt;
    const Levels levelsA(a, rowA);
    const Levels levelsB(b, rowB);
    if (common) {
        limit = 0.0;  // edges count where they meet
    } else if (std::isinf(limit)) {
        limit = lengthOfShortLine(levelsA, levelsB, b[rowB].anchor) + kTouchNm;  // rounding leaves nothing out
    }
    const std::optional<Spacing> edges = ClosestEdges(levelsA, levelsB, limit).find();
    const bool isInsideAlone = common && !(edges && edges->distance <= 0);
    return isInsideAlone ? Spacing{0.0, *common, *common} : edges;
}

std::optional<Spacing> spacingBetween(const FigureTable& a, const FigureTable& b, double limit) {
    std::optional<Spacing> best;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const auto spacing = spacingBetween(a, i, b, j, best ? best->distance : limit);
            best = spacing && (!best || spacing->distance < best->distance) ? spacing : best;
        }
    }
    return best;
}

}  // namespace model
