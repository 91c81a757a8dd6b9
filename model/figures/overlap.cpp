#include "model/figures/overlap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// Larger convex figures are treated as any other: the sum of two has as many corners as both together.
constexpr std::size_t kMostCorners = 64;
/// Corners of lines and arcs are rounded to whole nanometres.
constexpr double kRoundingNm = 1.5;
/// Points of one outline that are tried as the middle of a disc.
constexpr std::size_t kMostTried = 64;
/// Crossings of two outlines that are tested.
constexpr int kMostCrossings = 256;

/// A convex figure: all that is at most `pen` from the hull of some points.
struct Convex {
    std::vector<PointD> points;
    double pen = 0.0;
};

/// Does a closed path of corners turn one way only, and once?
bool isConvex(std::span<const PointD> corners) {
    double rotated = 0.0;
    if (corners.size() < 3) {
        return !corners.empty();
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointD in = minus(corners[(i + 1) % corners.size()], corners[i]);
        const PointD out = minus(corners[(i + 2) % corners.size()], corners[(i + 1) % corners.size()]);
        const double angle = std::atan2(cross(in, out), dot(in, out));
        if (angle * rotated < 0) {
            return false;
        }
        rotated += angle;
    }
    return std::abs(rotated) < 3 * std::numbers::pi;
}

/// Do the edges bend to the filled side only, all with one radius? Returns that radius, 0 if none bends.
std::optional<double> cornerRadius(std::span<const Edge> edges) {
    double radius = 0.0;
    for (const Edge& edge : edges) {
        const bool isOutward = edge.isClockwise != (edge.winding > 0);
        if (edge.isArc() && (!isOutward || (radius > 0 && std::abs(edge.radius - radius) > kRoundingNm))) {
            return std::nullopt;
        }
        radius = edge.isArc() ? edge.radius : radius;
    }
    return radius;
}

/// Does an edge of a rounded outline go on into the next one without a bend? Sides run at the radius' distance beside
/// the centres of their neighbours; arcs that follow each other have one centre.
bool isSmooth(const Edge& edge, const Edge& next, double radius) {
    if (edge.isArc() && next.isArc()) {
        return length(minus(edge.centre, next.centre)) <= kRoundingNm;
    }
    const Edge& side = edge.isArc() ? next : edge;
    const Edge& corner = edge.isArc() ? edge : next;
    const PointD delta = minus(side.b, side.a);
    const double beside = std::abs(cross(delta, minus(corner.centre, side.a))) / length(delta);
    return corner.isArc() && std::abs(beside - radius) <= kRoundingNm;
}

/// A convex polygon, sharp or with all corners rounded alike.
std::optional<Convex> convexOutline(std::span<const Edge> edges) {
    const std::optional<double> radius = cornerRadius(edges);
    if (!radius) {
        return std::nullopt;
    }
    Convex convex{{}, *radius};
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (*radius > 0 && !isSmooth(edges[i], edges[(i + 1) % edges.size()], *radius)) {
            return std::nullopt;
        }
        if (*radius == 0 || edges[i].isArc()) {
            convex.points.push_back(*radius == 0 ? edges[i].a : edges[i].centre);
        }
    }
    return isConvex(convex.points) ? std::optional(convex) : std::nullopt;
}

std::optional<Convex> convexOf(const FigureTable& table, std::size_t row) {
    const std::span<const Edge> edges = table.edges(row);
    const bool hasHoles = std::ranges::any_of(edges, &Edge::isHole);
    if (!table[row].isFilled && edges.size() == 1 && !edges[0].isArc()) {
        return Convex{{edges[0].a, edges[0].b}, edges[0].pen};
    }
    return table[row].isFilled && !hasHoles && edges.size() <= kMostCorners ? convexOutline(edges) : std::nullopt;
}

/// The hull of points, counter-clockwise, without points on its sides.
std::vector<PointD> hullOf(std::vector<PointD> points) {
    std::ranges::sort(points, [](PointD a, PointD b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<PointD> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const PointD p : points) {
            while (hull.size() >= start + 2 &&
                   cross(minus(hull.back(), hull[hull.size() - 2]), minus(p, hull.back())) <= 0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();  // the next pass begins with it
        std::ranges::reverse(points);
    }
    return hull;
}

/// How deep the origin is inside of a hull; negative outside: how far away.
double depthOfOrigin(const std::vector<PointD>& hull) {
    double nearest = std::numeric_limits<double>::infinity();
    bool isInside = hull.size() > 2;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        Edge side;
        side.a = hull[i];
        side.b = hull[(i + 1) % hull.size()];
        isInside = isInside && cross(minus(side.b, side.a), minus({}, side.a)) >= 0;
        nearest = std::min(nearest, length(nearestOn(side, {})));
    }
    return isInside ? nearest : -nearest;
}

/// Two convex figures share a point as long as the origin lies in the set of all differences of their points.
double depthBetween(const Convex& a, const Convex& b) {
    std::vector<PointD> differences;
    for (const PointD p : a.points) {
        for (const PointD q : b.points) {
            differences.push_back(minus(p, q));
        }
    }
    std::vector<PointD> hull = hullOf(std::move(differences));
    if (hull.empty()) {
        hull.push_back(minus(a.points.front(), b.points.front()));  // all points at one location
    }
    return std::max(0.0, a.pen + b.pen + depthOfOrigin(hull));
}

/// The largest disc around a point that the figure covers; 0 where that is no larger than `enough`.
double discAt(const FigureTable& table, std::size_t row, PointD p, double enough = 0.0) {
    if (table[row].isFilled) {
        const double toEdges = spacingToEdges(table, row, p, enough).distance;
        return toEdges > enough && isInside(table, row, p) ? toEdges : 0.0;
    }
    double largest = 0.0;
    Edge location;
    location.a = location.b = p;
    visitEdges(table, row, boxOf(location),
               [&](const Edge& edge) { largest = std::max(largest, edge.pen - length(minus(nearestOn(edge, p), p))); });
    return largest > enough ? largest : 0.0;
}

/// Of a point on a boundary, the unit vector to the filled side.
PointD inwardAt(const Edge& edge, PointD p) {
    PointD left = edge.isArc() ? minus(edge.centre, p) : PointD{edge.a.y - edge.b.y, edge.b.x - edge.a.x};
    double side = edge.winding * (edge.isHole ? -1.0 : 1.0) / std::max(length(left), 1e-9);
    side = edge.isArc() && edge.isClockwise ? -side : side;
    return {left.x * side, left.y * side};
}

/// Collects how deep two figures of any kind are in each other at least.
class DeepestDiscs {
public:
    DeepestDiscs(const FigureTable& a, std::size_t rowA, const FigureTable& b, std::size_t rowB)
        : m_a(a), m_rowA(rowA), m_b(b), m_rowB(rowB) {}

    double find(PointD shared) {
        tryAt(shared);
        tryAlong(m_a, m_rowA, m_b, m_rowB);
        tryAlong(m_b, m_rowB, m_a, m_rowA);
        visitEdges(m_a, m_rowA, m_b.box(m_rowB), [this](const Edge& e) { compareAround(e); });
        return m_deepest;
    }

private:
    void tryAt(PointD p) {
        const double inA = discAt(m_a, m_rowA, p);
        const double inB = inA > 0 ? discAt(m_b, m_rowB, p, std::max(0.0, m_deepest - inA)) : 0.0;
        m_deepest = std::max(m_deepest, inA > 0 && inB > 0 ? inA + inB : 0.0);
    }

    /// Of a track the middle line is deepest inside; of a boundary what it holds, so its corners are tried in the
    /// other.
    void tryAlong(const FigureTable& table, std::size_t row, const FigureTable& other, std::size_t otherRow) {
        const std::span<const Edge> edges = table.edges(row);
        const std::size_t step = edges.size() / kMostTried + 1;
        for (std::size_t i = 0; i < edges.size(); i += step) {
            for (const PointD p : {edges[i].a, pointAt(edges[i], lengthOf(edges[i]) / 2)}) {
                const double own = table[row].isFilled ? 0.0 : edges[i].pen;
                const double beyond = discAt(other, otherRow, p, std::max(0.0, m_deepest - own));
                m_deepest = std::max(m_deepest, beyond > 0 ? own + beyond : 0.0);
            }
        }
    }

    void compareAround(const Edge& e) {
        const Box box = boxOf(e);
        const Box reach = box.grownBy(static_cast<Nm>(std::ceil(kTouchNm)));
        visitEdges(m_b, m_rowB, box, [&](const Edge& f) {
            if (boxOf(f).meets(reach)) {
                compare(e, f);
            }
        });
    }

    void compare(const Edge& e, const Edge& f) {
        Edge middleE = e;
        Edge middleF = f;
        middleE.pen = middleF.pen = 0.0;
        if (e.pen + f.pen > 0) {
            m_deepest = std::max(m_deepest, e.pen + f.pen - spacingBetween(middleE, middleF).distance);
        } else if (m_a[m_rowA].isFilled && m_b[m_rowB].isFilled && m_crossings < kMostCrossings) {
            const Spacing spacing = spacingBetween(middleE, middleF);
            if (spacing.distance <= kTouchNm) {
                ++m_crossings;
                tryBehind(spacing.from, inwardAt(e, spacing.from), inwardAt(f, spacing.to));
            }
        }
    }

    /// Where two boundaries meet, what both fill begins between their inner sides, if there is anything.
    void tryBehind(PointD location, PointD inA, PointD inB) {
        const PointD delta = {inA.x + inB.x, inA.y + inB.y};
        const double full = length(delta);
        for (double step = 1.0; full > 1e-6 && step < 1e7; step *= 10) {
            tryAt({location.x + delta.x / full * step, location.y + delta.y / full * step});
        }
    }

    const FigureTable& m_a;
    std::size_t m_rowA;
    const FigureTable& m_b;
    std::size_t m_rowB;
    double m_deepest = 0.0;
    int m_crossings = 0;
};

}  // namespace

Overlap overlapBetween(const FigureTable& a, std::size_t rowA, const FigureTable& b, std::size_t rowB, PointD shared) {
    const std::optional<Convex> convexA = convexOf(a, rowA);
    const std::optional<Convex> convexB = convexOf(b, rowB);
    if (convexA && convexB) {
        return {depthBetween(*convexA, *convexB), true};
    }
    return {DeepestDiscs(a, rowA, b, rowB).find(shared), false};
}

}  // namespace model
