#include "model/solids/region_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace model {

namespace {

double pointDistance(PointD p, Point a, Point b) {
    const PointD d{double(b.x) - a.x, double(b.y) - a.y};
    const PointD v{p.x - a.x, p.y - a.y};
    const double length = d.x * d.x + d.y * d.y;
    const double t = length > 0 ? std::clamp((v.x * d.x + v.y * d.y) / length, 0.0, 1.0) : 0.0;
    return std::hypot(v.x - t * d.x, v.y - t * d.y);
}

/// Sign of the turn a → b → c; exact.
int orientation(Point a, Point b, Point c) {
    const auto product = [](std::int64_t x, std::int64_t y) { return static_cast<__int128>(x) * y; };
    const __int128 v = product(std::int64_t{b.x} - a.x, std::int64_t{c.y} - a.y) -
                       product(std::int64_t{b.y} - a.y, std::int64_t{c.x} - a.x);
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

bool boxesTouch(Point a, Point b, const Box& box, double margin) {
    return std::min(a.x, b.x) <= box.max.x + margin && std::max(a.x, b.x) >= box.min.x - margin &&
           std::min(a.y, b.y) <= box.max.y + margin && std::max(a.y, b.y) >= box.min.y - margin;
}

/// Does the whole box lie on one side of the line through a and b?
bool isBeside(const Box& box, Point a, Point b) {
    const int side = orientation(a, b, box.min);
    return side != 0 && orientation(a, b, box.max) == side && orientation(a, b, {box.min.x, box.max.y}) == side &&
           orientation(a, b, {box.max.x, box.min.y}) == side;
}

template <class Visit>
void forEachEdge(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons, const Visit& visit) {
    for (const PolygonSet::Polygon& polygon : polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            const std::span<const Point> loop = set.loop(polygon.firstLoop + i);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                visit(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]);
            }
        }
    }
}

/// Does the ray to the right from `p` cross this edge?
bool isCrossed(Point a, Point b, Point p) {
    if ((a.y > p.y) == (b.y > p.y)) {
        return false;
    }
    return orientation(a, b, p) == (b.y > a.y ? 1 : -1);
}

}  // namespace

Box boxOf(std::span<const Point> points) {
    Box box;
    for (const Point& point : points) {
        box.include(point);
    }
    return box;
}

bool contains(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons, Point p) {
    bool isInside = false;
    for (const PolygonSet::Polygon& polygon : polygons) {
        bool isIn = false;
        forEachEdge(set, std::span(&polygon, 1), [&](Point a, Point b) { isIn ^= isCrossed(a, b, p); });
        isInside = isInside || isIn;  // polygons of one cutout may overlap
    }
    return isInside;
}

namespace {

/// Edges of these polygons that come near a box.
std::vector<std::pair<Point, Point>> edgesNear(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons,
                                               const Box& box, double margin) {
    std::vector<std::pair<Point, Point>> found;
    forEachEdge(set, polygons, [&](Point a, Point b) {
        if (boxesTouch(a, b, box, margin)) {
            found.emplace_back(a, b);
        }
    });
    return found;
}

}  // namespace

double segmentDistance(Point a, Point b, Point c, Point d) {
    const bool isCrossing =
        orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
    if (isCrossing) {
        return 0.0;
    }
    using base::toDouble;
    return std::min({pointDistance(toDouble(a), c, d), pointDistance(toDouble(b), c, d),
                     pointDistance(toDouble(c), a, b), pointDistance(toDouble(d), a, b)});
}

bool regionsTouch(const PolygonSet& set, std::span<const PolygonSet::Polygon> a, std::span<const PolygonSet::Polygon> b,
                  const Box& boxA, const Box& boxB, double margin) {
    const auto edgesA = edgesNear(set, a, boxB, margin);
    const auto edgesB = edgesNear(set, b, boxA, margin);
    for (const auto& [p, q] : edgesA) {
        for (const auto& [r, s] : edgesB) {
            if (segmentDistance(p, q, r, s) < margin) {
                return true;
            }
        }
    }
    // No edges near each other: apart, or one inside the other.
    const auto firstPoint = [&set](std::span<const PolygonSet::Polygon> p) { return set.loop(p[0].firstLoop)[0]; };
    return contains(set, a, firstPoint(b)) || contains(set, b, firstPoint(a));
}

EdgeStrips::EdgeStrips(const PolygonSet& region)
    // About one edge per strip where edges are short and evenly spread.
    : m_box(boxOf(region.points)), m_first(std::clamp<std::size_t>(region.points.size(), 1, 4096) + 1, 0) {
    const auto forEachStrip = [&](const auto& visit) {
        forEachEdge(region, region.polygons, [&](Point a, Point b) {
            const std::size_t last = stripOf(std::max(a.y, b.y));
            for (std::size_t strip = stripOf(std::min(a.y, b.y)); strip <= last; ++strip) {
                visit(strip, Edge{a, b});
            }
        });
    };
    forEachStrip([&](std::size_t strip, const Edge&) { ++m_first[strip + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_edges.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    forEachStrip([&](std::size_t strip, const Edge& edge) { m_edges[next[strip]++] = edge; });
}

std::size_t EdgeStrips::stripOf(std::int64_t y) const {
    const std::int64_t offset = std::clamp<std::int64_t>(y - m_box.min.y, 0, m_box.height());
    return static_cast<std::size_t>(offset * static_cast<std::int64_t>(m_first.size() - 2) /
                                    std::max<std::int64_t>(m_box.height(), 1));
}

bool EdgeStrips::contains(Point p) const {
    if (m_box.isEmpty() || p.y < m_box.min.y || p.y > m_box.max.y) {
        return false;
    }
    bool isIn = false;
    for (const Edge& edge : edgesIn(stripOf(p.y))) {
        isIn ^= isCrossed(edge.a, edge.b, p);
    }
    return isIn;
}

bool EdgeStrips::meets(const Box& box) const {
    if (m_box.isEmpty()) {
        return false;
    }
    const std::size_t last = stripOf(box.max.y);
    for (std::size_t i = stripOf(box.min.y); i <= last; ++i) {
        for (const Edge& edge : edgesIn(i)) {
            if (boxesTouch(edge.a, edge.b, box, 0.0) && !isBeside(box, edge.a, edge.b)) {
                return true;
            }
        }
    }
    return false;
}

bool EdgeStrips::comesNear(const Edge& edge, const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons,
                           double margin) {
    Box around;
    around.include(edge.a);
    around.include(edge.b);
    bool isNear = false;
    forEachEdge(set, polygons, [&](Point a, Point b) {
        isNear = isNear || (boxesTouch(a, b, around, margin) && segmentDistance(edge.a, edge.b, a, b) < margin);
    });
    return isNear;
}

bool EdgeStrips::comesNear(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons, const Box& box,
                           double margin) const {
    const auto reach = static_cast<std::int64_t>(margin);
    const std::size_t last = stripOf(box.max.y + reach);
    for (std::size_t i = stripOf(box.min.y - reach); i <= last; ++i) {
        for (const Edge& edge : edgesIn(i)) {
            if (boxesTouch(edge.a, edge.b, box, margin) && comesNear(edge, set, polygons, margin)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace model
