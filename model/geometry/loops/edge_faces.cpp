#include "model/geometry/loops/edge_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "model/geometry/box_index.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

using Fragment = EdgeArrangement::Fragment;

constexpr double kThinnestNm = 1.0;
constexpr double kPi = std::numbers::pi;
constexpr double kNearlyOneDirection = 0.1;  ///< radians
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A fragment as it leaves a vertex.
struct Leaving {
    Side side = 0;
    double angle = 0.0;
    double turn = 0.0;   ///< half its signed curvature
    double reach = 0.0;  ///< length of its chord

    /// The direction from the vertex to its point that is so far away.
    [[nodiscard]] double angleAt(double distance) const { return angle + std::asin(distance * turn); }
};

/// The loop of sides around a face, which lies on their left.
struct Cycle {
    double area = 0.0;
    double perimeter = 0.0;
    Side longest = 0;
    double longestLength = -1.0;
    std::uint32_t component = kNone;
    int winding = 0;
    bool isInside = false;
};

class Faces {
public:
    explicit Faces(const EdgeArrangement& arrangement) : m_arrangement(arrangement) {
        m_edges.reserve(arrangement.fragments().size());
        for (const Fragment& fragment : arrangement.fragments()) {
            m_edges.push_back(arrangement.edgeOf(fragment));
        }
    }

    std::optional<std::vector<std::vector<Side>>> boundary() {
        if (!findFaces() || !findWindings()) {
            return std::nullopt;
        }
        dropThinFaces();
        return linkBoundary();
    }

    std::optional<std::vector<std::vector<Side>>> outerBoundary() {
        if (!findFaces()) {
            return std::nullopt;
        }
        for (Cycle& cycle : m_cycles) {
            cycle.isInside = true;
        }
        for (const std::uint32_t outside : m_outsides) {
            m_cycles[outside].isInside = false;
        }
        return linkBoundary();
    }

private:
    [[nodiscard]] std::uint32_t sideCount() const { return static_cast<std::uint32_t>(2 * m_edges.size()); }
    [[nodiscard]] const Fragment& fragmentOf(Side side) const { return m_arrangement.fragments()[side / 2]; }
    [[nodiscard]] std::uint32_t originOf(Side side) const {
        return side % 2 == 0 ? fragmentOf(side).a : fragmentOf(side).b;
    }
    [[nodiscard]] Edge edgeOf(Side side) const {
        return side % 2 == 0 ? m_edges[side / 2] : reversed(m_edges[side / 2]);
    }
    [[nodiscard]] Cycle& cycleOf(Side side) { return m_cycles[m_cycleOf[side]]; }
    [[nodiscard]] int countOf(Side side) const {
        return side % 2 == 0 ? fragmentOf(side).count : -fragmentOf(side).count;
    }

    [[nodiscard]] Leaving leaving(Side side) const {
        const Edge edge = edgeOf(side);
        const PointD chord = minus(edge.b, edge.a);
        const double reach = length(chord);
        if (!edge.isArc()) {
            return {side, std::atan2(chord.y, chord.x), 0.0, reach};
        }
        const PointD out = minus(edge.a, edge.centre);
        const double sense = edge.isClockwise ? -1.0 : 1.0;
        return {side, std::atan2(sense * out.x, -sense * out.y), sense / (2 * edge.radius), reach};
    }

    bool findFaces() {
        orderAroundVertices();
        traceCycles();
        findComponents();
        return isPlanar() && findOutsides();
    }

    void orderAroundVertices() {
        std::vector<std::uint32_t> first(m_arrangement.vertices().size() + 1, 0);
        for (Side side = 0; side < sideCount(); ++side) {
            ++first[originOf(side) + 1];
        }
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<Side> sides(sideCount());
        std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
        for (Side side = 0; side < sideCount(); ++side) {
            sides[fill[originOf(side)]++] = side;
        }
        m_next.resize(sideCount());
        std::vector<Leaving> around;
        for (std::size_t v = 0; v + 1 < first.size(); ++v) {
            around.clear();
            for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
                around.push_back(leaving(sides[i]));
            }
            sortAround(around);
            for (std::size_t i = 0; i < around.size(); ++i) {
                // The face left of what arrives goes on along the first that leaves clockwise from it.
                m_next[around[i].side ^ 1u] = around[(i + around.size() - 1) % around.size()].side;
            }
        }
    }

    /// Counter-clockwise. Those that leave in nearly one direction are compared where they are further apart.
    static void sortAround(std::vector<Leaving>& around) {
        std::ranges::sort(around, {}, &Leaving::angle);
        if (around.size() < 3) {
            return;
        }
        startBehindWidestSector(around);
        for (std::size_t i = 1; i < around.size(); ++i) {
            for (std::size_t k = i; k > 0 && isBefore(around[k], around[k - 1]); --k) {
                std::swap(around[k], around[k - 1]);
            }
        }
    }

    static void startBehindWidestSector(std::vector<Leaving>& around) {
        std::size_t start = 0;
        double widest = around.front().angle + 2 * kPi - around.back().angle;
        for (std::size_t i = 1; i < around.size(); ++i) {
            if (around[i].angle - around[i - 1].angle > widest) {
                widest = around[i].angle - around[i - 1].angle;
                start = i;
            }
        }
        for (std::size_t i = 0; i < start; ++i) {
            around[i].angle += 2 * kPi;
        }
        std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(start), around.end());
    }

    static bool isBefore(const Leaving& a, const Leaving& b) {
        if (std::abs(a.angle - b.angle) > kNearlyOneDirection) {
            return a.angle < b.angle;
        }
        const double away = 0.7 * std::min(a.reach, b.reach);
        return a.angleAt(away) < b.angleAt(away);
    }

    void traceCycles() {
        m_cycleOf.assign(sideCount(), kNone);
        for (Side start = 0; start < sideCount(); ++start) {
            if (m_cycleOf[start] != kNone) {
                continue;
            }
            Cycle cycle;
            const PointD base = m_arrangement.vertices()[originOf(start)];
            for (Side side = start; m_cycleOf[side] == kNone; side = m_next[side]) {
                m_cycleOf[side] = static_cast<std::uint32_t>(m_cycles.size());
                const Edge edge = edgeOf(side);
                const double full = distance(edge.a, edge.b);
                cycle.area += areaUnder(edge, base);
                cycle.perimeter += full;
                if (full > cycle.longestLength) {
                    cycle.longestLength = full;
                    cycle.longest = side;
                }
            }
            m_cycles.push_back(cycle);
            m_firstSide.push_back(start);
        }
    }

    /// What hangs together, by a walk over the cycles. m_order holds the cycles of one component after the other.
    void findComponents() {
        for (std::uint32_t seed = 0; seed < m_cycles.size(); ++seed) {
            if (m_cycles[seed].component != kNone) {
                continue;
            }
            m_cycles[seed].component = m_componentCount;
            m_componentStart.push_back(static_cast<std::uint32_t>(m_order.size()));
            m_order.push_back(seed);
            for (std::size_t i = m_componentStart.back(); i < m_order.size(); ++i) {
                visitNeighbours(m_order[i], [&](std::uint32_t, std::uint32_t to, Side) {
                    if (m_cycles[to].component == kNone) {
                        m_cycles[to].component = m_componentCount;
                        m_order.push_back(to);
                    }
                    return true;
                });
            }
            ++m_componentCount;
        }
        m_componentStart.push_back(static_cast<std::uint32_t>(m_order.size()));
    }

    /// Calls `visit(from, to, side)` for the cycles on the other side of each side of a cycle, until it returns false.
    template <class Visit>
    bool visitNeighbours(std::uint32_t from, const Visit& visit) const {
        Side side = m_firstSide[from];
        do {
            if (!visit(from, m_cycleOf[side ^ 1u], side)) {
                return false;
            }
            side = m_next[side];
        } while (side != m_firstSide[from]);
        return true;
    }

    /// Euler: vertices - edges + faces = 2 in every component.
    bool isPlanar() {
        std::vector<std::int64_t> sum(m_componentCount, 0);
        std::vector<std::uint8_t> isSeen(m_arrangement.vertices().size(), 0);
        for (Side side = 0; side < sideCount(); ++side) {
            const std::uint32_t vertex = originOf(side);
            sum[cycleOf(side).component] += isSeen[vertex] == 0 ? 1 : 0;
            sum[cycleOf(side).component] -= side % 2 == 0 ? 1 : 0;
            isSeen[vertex] = 1;
        }
        for (const Cycle& cycle : m_cycles) {
            ++sum[cycle.component];
        }
        return std::ranges::all_of(sum, [](std::int64_t s) { return s == 2; });
    }

    bool findOutsides() {
        for (std::uint32_t component = 0; component < m_componentCount; ++component) {
            const std::optional<std::uint32_t> outside = outsideOf(component);
            if (!outside) {
                return false;
            }
            m_outsides.push_back(*outside);
        }
        return true;
    }

    bool findWindings() {
        const std::optional<BoxIndex> index = m_componentCount > 1 ? std::optional(indexOfEdges()) : std::nullopt;
        std::vector<std::uint8_t> isKnown(m_cycles.size(), 0);
        for (const std::uint32_t outside : m_outsides) {
            m_cycles[outside].winding = index ? windingAt(*index, m_firstSide[outside]) : 0;
            if (!spreadWinding(outside, isKnown)) {
                return false;
            }
        }
        return true;
    }

    /// The only cycle of a component that runs clockwise.
    [[nodiscard]] std::optional<std::uint32_t> outsideOf(std::uint32_t component) const {
        std::optional<std::uint32_t> outside;
        for (std::uint32_t i = m_componentStart[component]; i < m_componentStart[component + 1]; ++i) {
            const Cycle& cycle = m_cycles[m_order[i]];
            if (cycle.area < -kThinnestNm * cycle.perimeter / 2) {
                if (outside) {
                    return std::nullopt;
                }
                outside = m_order[i];
            }
        }
        return outside ? outside : leastOf(component);
    }

    /// Of a component without area.
    [[nodiscard]] std::uint32_t leastOf(std::uint32_t component) const {
        const auto first = m_order.begin() + m_componentStart[component];
        const auto last = m_order.begin() + m_componentStart[component + 1];
        return *std::ranges::min_element(first, last, {}, [&](std::uint32_t c) { return m_cycles[c].area; });
    }

    [[nodiscard]] BoxIndex indexOfEdges() const {
        std::vector<Box> boxes;
        boxes.reserve(m_edges.size());
        for (const Edge& edge : m_edges) {
            boxes.push_back(boxOf(edge));
        }
        return BoxIndex(boxes);
    }

    /// The winding number of all other components where this one is.
    [[nodiscard]] int windingAt(const BoxIndex& index, Side side) {
        const PointD p = m_arrangement.vertices()[originOf(side)];
        const std::uint32_t own = cycleOf(side).component;
        Box ray = boxAround(p, 1.0);
        ray.max.x = std::numeric_limits<Nm>::max();
        int winding = 0;
        index.visit(ray, [&](std::uint32_t row) {
            if (cycleOf(2 * row).component != own) {
                winding += m_arrangement.fragments()[row].count * windingAround(m_edges[row], p);
            }
        });
        return winding;
    }

    bool spreadWinding(std::uint32_t outside, std::vector<std::uint8_t>& isKnown) {
        isKnown[outside] = 1;
        std::vector<std::uint32_t> queue{outside};
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const bool isConsistent = visitNeighbours(queue[i], [&](std::uint32_t from, std::uint32_t to, Side side) {
                const int winding = m_cycles[from].winding - countOf(side);
                if (isKnown[to] == 0) {
                    isKnown[to] = 1;
                    m_cycles[to].winding = winding;
                    queue.push_back(to);
                }
                return m_cycles[to].winding == winding;
            });
            if (!isConsistent) {
                return false;
            }
        }
        return true;
    }

    void dropThinFaces() {
        for (Cycle& cycle : m_cycles) {
            cycle.isInside = cycle.winding > 0;
        }
        std::vector<std::uint8_t> isOutside(m_cycles.size(), 0);
        for (const std::uint32_t cycle : m_outsides) {
            isOutside[cycle] = 1;
        }
        for (std::size_t i = 0; i < m_cycles.size(); ++i) {
            Cycle& cycle = m_cycles[i];
            if (isOutside[i] == 0 && 2 * cycle.area < kThinnestNm * cycle.perimeter) {
                cycle.isInside = cycleOf(cycle.longest ^ 1u).isInside;
            }
        }
    }

    [[nodiscard]] bool isBoundary(Side side) { return cycleOf(side).isInside && !cycleOf(side ^ 1u).isInside; }

    std::vector<std::vector<Side>> linkBoundary() {
        std::vector<std::vector<Side>> loops;
        std::vector<std::uint8_t> isUsed(sideCount(), 0);
        for (Side start = 0; start < sideCount(); ++start) {
            if (isUsed[start] != 0 || !isBoundary(start)) {
                continue;
            }
            std::vector<Side>& loop = loops.emplace_back();
            for (Side side = start; isUsed[side] == 0; side = nextOfBoundary(side)) {
                isUsed[side] = 1;
                loop.push_back(side);
            }
        }
        return loops;
    }

    /// Around the vertex, clockwise through the inside.
    Side nextOfBoundary(Side side) {
        Side next = m_next[side];
        while (!isBoundary(next)) {
            next = m_next[next ^ 1u];
        }
        return next;
    }

    const EdgeArrangement& m_arrangement;
    std::vector<Edge> m_edges;
    std::vector<Side> m_next;
    std::vector<std::uint32_t> m_cycleOf;
    std::vector<Cycle> m_cycles;
    std::vector<Side> m_firstSide;
    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_componentStart;
    std::vector<std::uint32_t> m_outsides;
    std::uint32_t m_componentCount = 0;
};

}  // namespace

std::optional<std::vector<std::vector<Side>>> boundaryOf(const EdgeArrangement& arrangement) {
    return Faces(arrangement).boundary();
}

std::optional<std::vector<std::vector<Side>>> outerBoundaryOf(const EdgeArrangement& arrangement) {
    return Faces(arrangement).outerBoundary();
}

}  // namespace model
