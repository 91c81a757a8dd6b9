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

    [[nodiscard]] double alongOf(PointD p) const { return along.x * p.x + along.y * p.y; }
    void include(PointD p) {
        const double t = along.x * p.y - along.y * p.x;
        low = std::min(low, alongOf(p));
        high = std::max(high, alongOf(p));
        left = std::max(left, t);
        right = std::min(right, t);
    }
    [[nodiscard]] PointD at(double s, double t) const { return {along.x * s - along.y * t, along.y * s + along.x * t}; }
};

struct Side {
    PointD from;
    PointD to;
};

Side longestSide(const PathNodes& nodes) {
    Side longest;
    double length = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Side side = {base::toDouble(nodes[i].point), base::toDouble(nodes.endOf(i))};
        const double of = std::hypot(side.to.x - side.from.x, side.to.y - side.from.y);
        if (nodes[i].edge == EdgeKind::Line && of > length) {
            longest = side;
            length = of;
        }
    }
    return longest;
}

double distance(PointD p, PointD a, PointD b) {
    const PointD ab = {b.x - a.x, b.y - a.y};
    const double square = ab.x * ab.x + ab.y * ab.y;
    const double part = square > 0 ? std::clamp(((p.x - a.x) * ab.x + (p.y - a.y) * ab.y) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - part * ab.x, p.y - a.y - part * ab.y);
}

/// The stadium from `a` to `b` that all nodes lie on.
std::optional<Stadium> stadiumBetween(const PathNodes& nodes, PointD a, PointD b) {
    double radius = 0.0;  // the mean: corners are rounded
    for (const PathNode& node : nodes) {
        radius += distance(base::toDouble(node.point), a, b) / static_cast<double>(nodes.size());
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point end = nodes.endOf(i);
        const PointD half = {(static_cast<double>(nodes[i].point.x) + end.x) / 2,
                             (static_cast<double>(nodes[i].point.y) + end.y) / 2};
        const PointD centre = base::toDouble(nodes[i].centre);
        const double off =
            std::min(std::hypot(centre.x - a.x, centre.y - a.y), std::hypot(centre.x - b.x, centre.y - b.y));
        const bool isRound = isArc(nodes[i].edge) ? off <= kTolerance : distance(half, a, b) >= kNearestChord * radius;
        if (!isRound || std::abs(distance(base::toDouble(nodes[i].point), a, b) - radius) > kTolerance) {
            return std::nullopt;
        }
    }
    return Stadium{rounded(a), rounded(b), static_cast<Nm>(std::llround(2 * radius))};
}

}  // namespace

std::optional<Stadium> stadiumOf(const ShapeSketch& region) {
    if (region.contourCount() != 1) {
        return std::nullopt;
    }
    const PathNodes nodes = region.contour(0);
    const Side side = longestSide(nodes);
    const double length = std::hypot(side.to.x - side.from.x, side.to.y - side.from.y);
    if (length <= kTolerance) {
        return std::nullopt;
    }
    Frame frame;
    frame.along = {(side.to.x - side.from.x) / length, (side.to.y - side.from.y) / length};
    for (const PathNode& node : nodes) {
        frame.include(base::toDouble(node.point));
    }
    // Polygons have corners either where the ends begin or half a chord beside; arcs begin where the sides end.
    const double middle = (frame.left + frame.right) / 2;
    const double across = frame.left - frame.right;
    const auto onAxis = [&](double s) { return frame.at(s, middle); };
    const auto exact = stadiumBetween(nodes, onAxis(frame.alongOf(side.from)), onAxis(frame.alongOf(side.to)));
    if (exact || frame.high - frame.low <= across + kTolerance) {
        return exact;
    }
    return stadiumBetween(nodes, onAxis(frame.low + across / 2), onAxis(frame.high - across / 2));
}

}  // namespace model::ipc2581
