#include "model/formats/ipc2581/shapes/stadium.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

/// Corners are rounded to the grid of the file.
constexpr double kTolerance = 2'000.0;
/// Chords of a circle of 16 pass its centre no nearer than this part of its radius.
constexpr double kNearestChord = 0.98;

/// An axis and the extents of points along it and across.
struct Frame {
    PointD along;
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    double left = std::numeric_limits<double>::lowest();
    double right = std::numeric_limits<double>::max();

    void include(Point p) {
        const double s = along.x * p.x + along.y * p.y;
        const double t = along.x * p.y - along.y * p.x;
        low = std::min(low, s);
        high = std::max(high, s);
        left = std::max(left, t);
        right = std::min(right, t);
    }
    [[nodiscard]] PointD at(double s, double t) const { return {along.x * s - along.y * t, along.y * s + along.x * t}; }
};

PointD longestEdge(const PathNodes& nodes) {
    PointD longest;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point end = nodes.endOf(i);
        const PointD edge = {static_cast<double>(end.x) - nodes[i].point.x,
                             static_cast<double>(end.y) - nodes[i].point.y};
        if (nodes[i].edge == EdgeKind::Line && std::hypot(edge.x, edge.y) > std::hypot(longest.x, longest.y)) {
            longest = edge;
        }
    }
    return longest;
}

double distance(PointD p, PointD a, PointD b) {
    const PointD ab = {b.x - a.x, b.y - a.y};
    const double length = ab.x * ab.x + ab.y * ab.y;
    const double part = std::clamp(((p.x - a.x) * ab.x + (p.y - a.y) * ab.y) / length, 0.0, 1.0);
    return std::hypot(p.x - a.x - part * ab.x, p.y - a.y - part * ab.y);
}

}  // namespace

std::optional<Stadium> stadiumOf(const ShapeSketch& region) {
    if (region.contourCount() != 1) {
        return std::nullopt;
    }
    const PathNodes nodes = region.contour(0);
    const PointD edge = longestEdge(nodes);
    const double length = std::hypot(edge.x, edge.y);
    if (length <= kTolerance) {
        return std::nullopt;
    }
    Frame frame;
    frame.along = {edge.x / length, edge.y / length};
    for (const PathNode& node : nodes) {
        frame.include(node.point);
        if (isArc(node.edge)) {  // its far end, which no corner marks, is half a circle away from the straight sides
            const double radius = std::hypot(static_cast<double>(node.point.x) - node.centre.x,
                                             static_cast<double>(node.point.y) - node.centre.y);
            frame.include(rounded({node.centre.x + frame.along.x * radius, node.centre.y + frame.along.y * radius}));
            frame.include(rounded({node.centre.x - frame.along.x * radius, node.centre.y - frame.along.y * radius}));
        }
    }
    const double across = frame.left - frame.right;
    const double middle = (frame.left + frame.right) / 2;
    if (frame.high - frame.low <= across + kTolerance) {
        return std::nullopt;
    }
    const PointD a = frame.at(frame.low + across / 2, middle);
    const PointD b = frame.at(frame.high - across / 2, middle);
    double radius = 0.0;
    for (const PathNode& node : nodes) {
        radius = std::max(radius, distance(base::toDouble(node.point), a, b));
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point end = nodes.endOf(i);
        const PointD half = {(static_cast<double>(nodes[i].point.x) + end.x) / 2,
                             (static_cast<double>(nodes[i].point.y) + end.y) / 2};
        const bool isOnEdge = std::abs(distance(base::toDouble(nodes[i].point), a, b) - radius) <= kTolerance;
        const PointD centre = base::toDouble(nodes[i].centre);
        const bool isRound = isArc(nodes[i].edge) ? std::min(std::hypot(centre.x - a.x, centre.y - a.y),
                                                             std::hypot(centre.x - b.x, centre.y - b.y)) <= kTolerance
                                                  : distance(half, a, b) >= kNearestChord * radius;
        if (!isOnEdge || !isRound) {
            return std::nullopt;
        }
    }
    return Stadium{rounded(a), rounded(b), static_cast<Nm>(std::llround(2 * radius))};
}

}  // namespace model::ipc2581
