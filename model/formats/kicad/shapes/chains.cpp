#include "model/formats/kicad/shapes/chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "model/base/disjoint_sets.h"
#include "model/geometry/discretise.h"
#include "model/geometry/edges.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::kicad {

namespace {

/// Ends of edges; those that are near each other are one.
class Joints {
public:
    explicit Joints(double tolerance) : m_tolerance(std::max(tolerance, 1.0)) {}

    std::uint32_t at(Point p) {
        const std::int64_t x = cellOf(p.x);
        const std::int64_t y = cellOf(p.y);
        std::optional<std::uint32_t> nearest;
        double nearestDistance = m_tolerance;
        for (std::int64_t i = x - 1; i <= x + 1; ++i) {
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const auto found = m_cells.find(keyOf(i, j));
                for (std::size_t k = 0; found != m_cells.end() && k < found->second.size(); ++k) {
                    const Point other = m_points[found->second[k]];
                    const double distance = std::hypot(double(other.x) - p.x, double(other.y) - p.y);
                    if (distance <= nearestDistance) {
                        nearestDistance = distance;
                        nearest = found->second[k];
                    }
                }
            }
        }
        if (nearest) {
            m_widest = std::max(m_widest, nearestDistance);
            return *nearest;
        }
        m_cells[keyOf(x, y)].push_back(static_cast<std::uint32_t>(m_points.size()));
        m_points.push_back(p);
        return static_cast<std::uint32_t>(m_points.size() - 1);
    }

    [[nodiscard]] Point point(std::uint32_t joint) const { return m_points[joint]; }
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    [[nodiscard]] double widest() const { return m_widest; }

private:
    [[nodiscard]] std::int64_t cellOf(Nm value) const {
        return static_cast<std::int64_t>(std::floor(value / m_tolerance));
    }
    static std::int64_t keyOf(std::int64_t x, std::int64_t y) { return x * 0x100000000 + y; }

    double m_tolerance;
    double m_widest = 0.0;
    std::vector<Point> m_points;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> m_cells;
};

/// Of an edge whose ends are one joint: is it an arc all around, and not one shorter than the joint is wide?
bool isCircle(const ChainEdge& edge) {
    const PathNode& from = edge.from;
    const double cross =
        double(std::int64_t{from.point.x} - from.centre.x) * double(std::int64_t{edge.to.y} - from.centre.y) -
        double(std::int64_t{from.point.y} - from.centre.y) * double(std::int64_t{edge.to.x} - from.centre.x);
    return isArc(from.edge) && (from.edge == EdgeKind::ArcClockwise ? cross >= 0.0 : cross <= 0.0);
}

class Chainer {
public:
    Chainer(std::span<const ChainEdge> edges, double tolerance) : m_edges(edges), m_joints(tolerance) {
        for (const ChainEdge& edge : edges) {
            m_ends.push_back({m_joints.at(edge.from.point), m_joints.at(edge.to)});
        }
        m_isUsed.resize(edges.size());
        m_edgesAt.resize(m_joints.size());
        leaveOutRepeated(tolerance);
    }

    Chains run() {
        takeClosedEdges();
        pruneDeadEnds();
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            if (!m_isUsed[i]) {
                walk(i);
            }
        }
        m_chains.widestJoint = m_joints.widest();
        std::ranges::sort(m_chains.open);
        return std::move(m_chains);
    }

    std::vector<std::vector<ChainEdge>> drawings() {
        takeClosedEdges();
        pruneDeadEnds();
        DisjointSets groups(m_joints.size());
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            if (isOfDrawing(i)) {
                groups.join(m_ends[i].a, m_ends[i].b);
            }
        }
        std::map<std::uint32_t, std::vector<ChainEdge>> byGroup;
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            if (isOfDrawing(i)) {
                byGroup[groups.find(m_ends[i].a)].push_back(joined(i));
            }
        }
        std::vector<std::vector<ChainEdge>> drawings;
        for (auto& [group, edges] : byGroup) {
            drawings.push_back(std::move(edges));
        }
        return drawings;
    }

private:
    struct Ends {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
    };

    /// Is it a closed arc, or has it not been taken out as a dead end?
    [[nodiscard]] bool isOfDrawing(std::uint32_t edge) const {
        return !m_isUsed[edge] || (m_ends[edge].a == m_ends[edge].b && isCircle(m_edges[edge]));
    }

    [[nodiscard]] ChainEdge joined(std::uint32_t row) const {
        ChainEdge edge = m_edges[row];
        edge.from.point = m_joints.point(m_ends[row].a);
        edge.to = m_joints.point(m_ends[row].b);
        return edge;
    }

    /// An edge on another one would close a loop with it that holds nothing, or make a second outline within the first
    /// one.
    void leaveOutRepeated(double tolerance) {
        Joints centres(tolerance);
        std::set<std::tuple<std::uint32_t, std::uint32_t, EdgeKind, std::uint32_t>> known;
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            const PathNode& from = m_edges[i].from;
            const auto [a, b] = m_ends[i];
            if (from.edge == EdgeKind::Curve || (a == b && !isCircle(m_edges[i]))) {
                continue;
            }
            // As it runs from its first joint to a later one; circles run either way.
            const EdgeKind kind = a == b ? EdgeKind::ArcClockwise : a > b ? reversed(from.edge) : from.edge;
            const std::uint32_t centre = isArc(kind) ? centres.at(from.centre) : 0;
            if (!known.emplace(std::min(a, b), std::max(a, b), kind, centre).second) {
                m_isUsed[i] = true;
                ++m_chains.repeated;
            }
        }
    }

    void takeClosedEdges() {
        for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
            if (m_isUsed[i]) {
                continue;
            }
            const bool isClosed = m_ends[i].a == m_ends[i].b;
            if (!isClosed) {
                m_edgesAt[m_ends[i].a].push_back(i);
                m_edgesAt[m_ends[i].b].push_back(i);
                continue;
            }
            m_isUsed[i] = true;
            if (isCircle(m_edges[i])) {
                m_chains.loops.push_back({m_edges[i].from});
            }
        }
    }

    void pruneDeadEnds() {
        std::vector<std::uint32_t> degree(m_joints.size());
        std::vector<std::uint32_t> ends;
        for (std::uint32_t joint = 0; joint < degree.size(); ++joint) {
            degree[joint] = static_cast<std::uint32_t>(m_edgesAt[joint].size());
            if (degree[joint] == 1) {
                ends.push_back(joint);
            }
        }
        while (!ends.empty()) {
            const std::uint32_t joint = ends.back();
            ends.pop_back();
            for (const std::uint32_t edge : m_edgesAt[joint]) {
                if (!m_isUsed[edge]) {
                    m_isUsed[edge] = true;
                    m_chains.open.push_back(edge);
                    const std::uint32_t other = m_ends[edge].a == joint ? m_ends[edge].b : m_ends[edge].a;
                    if (--degree[other] == 1) {
                        ends.push_back(other);
                    }
                }
            }
        }
    }

    /// From an edge on until it is back at a joint that it has passed.
    void walk(std::uint32_t first) {
        std::vector<std::uint32_t> path;
        std::unordered_map<std::uint32_t, std::size_t> passed{{m_ends[first].a, 0}};
        std::vector<std::uint32_t> joints{m_ends[first].a};
        for (std::optional<std::uint32_t> edge = first; edge; edge = nextFrom(joints.back())) {
            m_isUsed[*edge] = true;
            path.push_back(*edge);
            const std::uint32_t joint = m_ends[*edge].a == joints.back() ? m_ends[*edge].b : m_ends[*edge].a;
            const auto [found, isNew] = passed.try_emplace(joint, joints.size());
            if (!isNew) {
                takeLoop(path, joints, found->second);
                m_chains.open.insert(m_chains.open.end(), path.begin(),
                                     path.begin() + static_cast<std::ptrdiff_t>(found->second));
                return;
            }
            joints.push_back(joint);
        }
        m_chains.open.insert(m_chains.open.end(), path.begin(), path.end());
    }

    std::optional<std::uint32_t> nextFrom(std::uint32_t joint) const {
        for (const std::uint32_t edge : m_edgesAt[joint]) {
            if (!m_isUsed[edge]) {
                return edge;
            }
        }
        return {};
    }

    void takeLoop(std::span<const std::uint32_t> path, std::span<const std::uint32_t> joints, std::size_t begin) {
        std::vector<PathNode> loop;
        for (std::size_t i = begin; i < path.size(); ++i) {
            PathNode node = m_edges[path[i]].from;
            const bool isReversed = m_ends[path[i]].a != joints[i];
            node.edge = isReversed ? reversed(node.edge) : node.edge;
            node.point = m_joints.point(joints[i]);
            loop.push_back(node);
        }
        m_chains.loops.push_back(std::move(loop));
    }

    std::span<const ChainEdge> m_edges;
    Joints m_joints;
    std::vector<Ends> m_ends;
    std::vector<bool> m_isUsed;
    std::vector<std::vector<std::uint32_t>> m_edgesAt;
    Chains m_chains;
};

std::vector<Point> pointsOf(const std::vector<PathNode>& loop) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        discretiseEdge(loop[i], loop[(i + 1) % loop.size()].point, kBooleanChords, points);
    }
    return points;
}

bool isInside(Point p, const std::vector<Point>& loop) {
    bool isIn = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Point a = loop[i];
        const Point b = loop[j];
        if ((a.y > p.y) != (b.y > p.y) &&
            p.x < double(b.x - std::int64_t{a.x}) * double(p.y - std::int64_t{a.y}) / double(b.y - std::int64_t{a.y}) +
                      a.x) {
            isIn = !isIn;
        }
    }
    return isIn;
}

}  // namespace

Chains chained(std::span<const ChainEdge> edges, double tolerance) {
    return Chainer(edges, tolerance).run();
}

std::vector<std::vector<ChainEdge>> drawings(std::span<const ChainEdge> edges, double tolerance) {
    return Chainer(edges, tolerance).drawings();
}

ShapeSketch nested(std::span<const std::vector<PathNode>> loops) {
    std::vector<std::vector<Point>> polygons;
    std::vector<Box> boxes;
    for (const std::vector<PathNode>& loop : loops) {
        polygons.push_back(pointsOf(loop));
        boxes.emplace_back();
        for (const Point p : polygons.back()) {
            boxes.back().include(p);
        }
    }
    ShapeSketch islands;
    ShapeSketch holes;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        std::size_t depth = 0;
        for (std::size_t j = 0; j < loops.size(); ++j) {
            depth += i != j && boxes[j].holds(polygons[i][0]) && isInside(polygons[i][0], polygons[j]) ? 1 : 0;
        }
        addPath(depth % 2 == 0 ? islands : holes, loops[i], depth % 2 != 0);
    }
    islands.append(holes, {});
    return islands;
}

}  // namespace model::kicad
