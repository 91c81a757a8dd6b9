#include "model/geometry/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/base/limits.h"

namespace model {

Point rounded(PointD p) {
    return {static_cast<Nm>(std::llround(p.x)), static_cast<Nm>(std::llround(p.y))};
}

void addLoop(ShapeSketch& sketch, std::span<const PointD> points, bool isHole) {
    std::vector<PathNode> nodes;
    for (const PointD& point : points) {
        nodes.push_back({rounded(point), {}, EdgeKind::Line});
    }
    addPath(sketch, nodes, isHole);
}

void addPath(ShapeSketch& sketch, std::span<const PathNode> nodes, bool isHole) {
    sketch.beginContour(isHole);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point next = nodes[(i + 1) % nodes.size()].point;
        if (nodes[i].edge != EdgeKind::Line || nodes[i].point != next) {
            sketch.addNode(nodes[i]);
        }
    }
}

void addBox(ShapeSketch& sketch, double width, double height, bool isHole) {
    const double x = width / 2;
    const double y = height / 2;
    addLoop(sketch, std::array<PointD, 4>{{{x, y}, {-x, y}, {-x, -y}, {x, -y}}}, isHole);
}

void addBox(ShapeSketch& sketch, const Box& box) {
    sketch.addPolygon(std::array{box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}}, false);
}

void addCornerBox(ShapeSketch& sketch, double width, double height, double radius, unsigned corners, CornerStyle style,
                  bool isHole) {
    // Signs of the corners, counter-clockwise from the top right.
    constexpr std::array<PointD, 4> kCorners = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    const double r = std::clamp(radius, 0.0, std::min(width, height) / 2);
    std::vector<PathNode> nodes;
    for (std::size_t i = 0; i < 4; ++i) {
        const PointD corner = {kCorners[i].x * width / 2, kCorners[i].y * height / 2};
        if ((corners & (1U << i)) == 0 || r == 0.0) {
            nodes.push_back({rounded(corner), {}, EdgeKind::Line});
            continue;
        }
        const PointD centre = {corner.x - kCorners[i].x * r, corner.y - kCorners[i].y * r};
        const PointD onSide = {corner.x, centre.y};  // on the left or right side
        const PointD onFlat = {centre.x, corner.y};  // on the top or bottom
        const bool sideFirst = i % 2 == 0;           // walking counter-clockwise
        const EdgeKind edge = style == CornerStyle::Rounded ? EdgeKind::ArcCounterClockwise : EdgeKind::Line;
        nodes.push_back({rounded(sideFirst ? onSide : onFlat), rounded(centre), edge});
        nodes.push_back({rounded(sideFirst ? onFlat : onSide), {}, EdgeKind::Line});
    }
    addPath(sketch, nodes, isHole);
}

namespace {

PointD towards(PointD from, PointD to, double distance) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    return {from.x + (to.x - from.x) / length * distance, from.y + (to.y - from.y) / length * distance};
}

/// The nodes of one corner: itself, or an arc between the points where it touches the sides.
void roundCorner(std::vector<PathNode>& nodes, PointD before, const Corner& corner, PointD after) {
    const PointD a = {before.x - corner.point.x, before.y - corner.point.y};
    const PointD b = {after.x - corner.point.x, after.y - corner.point.y};
    const double shorter = std::min(std::hypot(a.x, a.y), std::hypot(b.x, b.y));
    const double cross = b.x * a.y - b.y * a.x;  // positive: a left turn
    const double angle = std::atan2(std::abs(cross), a.x * b.x + a.y * b.y);
    if (corner.radius <= 0.0 || shorter < 1.0 || std::abs(cross) < 1.0) {
        nodes.push_back({rounded(corner.point), {}, EdgeKind::Line});
        return;
    }
    const double along = std::min(corner.radius / std::tan(angle / 2), shorter / 2);
    const PointD start = towards(corner.point, before, along);
    const PointD end = towards(corner.point, after, along);
    const PointD middle = {(start.x + end.x) / 2, (start.y + end.y) / 2};
    // The centre lies on the bisector: along / cos(angle / 2) from the corner.
    const PointD centre = towards(corner.point, middle, along / std::cos(angle / 2));
    const EdgeKind edge = cross > 0 ? EdgeKind::ArcCounterClockwise : EdgeKind::ArcClockwise;
    nodes.push_back({rounded(start), rounded(centre), edge});
    nodes.push_back({rounded(end), {}, EdgeKind::Line});
}

}  // namespace

void addRoundedLoop(ShapeSketch& sketch, std::span<const Corner> corners) {
    std::vector<PathNode> nodes;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        roundCorner(nodes, corners[(i + count - 1) % count].point, corners[i], corners[(i + 1) % count].point);
    }
    addPath(sketch, nodes, false);
}

void addCapsule(ShapeSketch& sketch, PointD from, PointD to, double width) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (width <= 0.0) {
        return;
    }
    if (length == 0.0) {
        return sketch.addCircle(rounded(from), static_cast<Nm>(std::llround(width / 2)), false);
    }
    const PointD side = {(from.y - to.y) / length * width / 2, (to.x - from.x) / length * width / 2};
    const auto beside = [&](PointD p, double sign) { return rounded({p.x + sign * side.x, p.y + sign * side.y}); };
    addPath(sketch,
            std::array<PathNode, 4>{{{beside(from, -1), {}, EdgeKind::Line},
                                     {beside(to, -1), rounded(to), EdgeKind::ArcCounterClockwise},
                                     {beside(to, 1), {}, EdgeKind::Line},
                                     {beside(from, 1), rounded(from), EdgeKind::ArcCounterClockwise}}},
            false);
}

void addOval(ShapeSketch& sketch, double width, double height, bool isHole) {
    addCornerBox(sketch, width, height, std::min(width, height) / 2, kAllCorners, CornerStyle::Rounded, isHole);
}

void addDisc(ShapeSketch& sketch, double diameter, bool isHole) {
    sketch.addCircle({}, static_cast<Nm>(std::llround(diameter / 2)), isHole);
}

void addEllipse(ShapeSketch& sketch, double width, double height) {
    // Sagitta of a chord on a circle of the larger radius: r (1 - cos(pi / n)) <= 500 nm.
    const double radius = std::max(width, height) / 2;
    const double cosine = std::clamp(1.0 - 500.0 / std::max(radius, 1000.0), -1.0, 1.0);
    const int count = 4 * std::clamp(static_cast<int>(std::ceil(std::numbers::pi / std::acos(cosine) / 4)), 4, 1024);
    std::vector<PointD> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        points.push_back({width / 2 * std::cos(angle), height / 2 * std::sin(angle)});
    }
    addLoop(sketch, points, false);
}

namespace {

/// Twice the signed area of the triangle a, b, c.
std::int64_t turn(Point a, Point b, Point c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

}  // namespace

bool hasTooManyCorners(const ShapeSketch& sketch) {
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        if (sketch.contour(i).size() > base::kMostCorners) {
            return true;
        }
    }
    return false;
}

Box boxOf(const ShapeSketch& sketch) {
    Box box;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        box.include(boxOfPath(sketch.contour(i), true));
    }
    return box;
}

std::vector<Point> convexHull(std::vector<Point> points) {
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    // Andrew's monotone chain: the lower hull, then the upper one.
    std::vector<Point> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

}  // namespace model
