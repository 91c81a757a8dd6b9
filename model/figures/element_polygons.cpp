#include "model/figures/element_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/figures/tracks.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kFullCircle = 2.0 * std::numbers::pi;

/// One polygon with this outline.
void addOutline(PolygonSet& set, std::span<const Point> outline) {
    set.beginPolygon();
    if (!set.addLoop(outline)) {
        set.polygons.pop_back();
    }
}

std::vector<Point> circlePoints(Point centre, Nm diameter, const Discretisation& how) {
    std::vector<Point> points;
    const Nm radius = diameter / 2;
    const PathNode node{{centre.x + radius, centre.y}, centre, EdgeKind::ArcCounterClockwise};
    discretiseEdge(node, node.point, how, points);
    return points;
}

/// The region of a round pen along a straight track, counter-clockwise.
std::vector<Point> capsulePoints(Point a, Point b, Nm width, const Discretisation& how) {
    if (a == b) {
        return circlePoints(a, width, how);
    }
    const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    const double nx = -(double(b.y) - a.y) / length * width / 2.0;  // left normal, one pen radius long
    const double ny = (double(b.x) - a.x) / length * width / 2.0;
    const auto offset = [](Point p, double x, double y) { return Point{toNm(p.x + x), toNm(p.y + y)}; };
    std::vector<Point> points;
    const Point right = offset(b, -nx, -ny);
    const Point left = offset(a, nx, ny);
    discretiseEdge({right, b, EdgeKind::ArcCounterClockwise}, offset(b, nx, ny), how, points);
    points.push_back(offset(b, nx, ny));
    discretiseEdge({left, a, EdgeKind::ArcCounterClockwise}, offset(a, -nx, -ny), how, points);
    points.push_back(offset(a, -nx, -ny));
    return points;
}

std::vector<Point> squarePenPoints(const LineGeometry& line) {
    const Nm r = line.width / 2;
    // Both squares' corners; the hull of two equal squares has at most six corners and `unite` is not needed: take the
    // extreme corners on either side of the track.
    const bool isRising = (std::int64_t{line.b.x} - line.a.x) * (std::int64_t{line.b.y} - line.a.y) >= 0;
    const Point low{std::min(line.a.x, line.b.x), std::min(line.a.y, line.b.y)};
    const Point high{std::max(line.a.x, line.b.x), std::max(line.a.y, line.b.y)};
    if (isRising) {
        return {{low.x - r, low.y - r},   {low.x + r, low.y - r},   {high.x + r, high.y - r},
                {high.x + r, high.y + r}, {high.x - r, high.y + r}, {low.x - r, low.y + r}};
    }
    return {{low.x - r, high.y - r}, {high.x - r, low.y - r}, {high.x + r, low.y - r},
            {high.x + r, low.y + r}, {low.x + r, high.y + r}, {low.x - r, high.y + r}};
}

void addArcTrack(const PathNode& node, Point end, Nm width, const Discretisation& how, PolygonSet& set) {
    const double sweep = sweepOf(node, end);
    const double radius = std::hypot(double(node.point.x) - node.centre.x, double(node.point.y) - node.centre.y);
    const double half = width / 2.0;
    if (std::abs(sweep) >= kFullCircle) {
        set.beginPolygon();
        set.addLoop(circlePoints(node.centre, toNm(2.0 * (radius + half)), how));
        if (radius > half) {
            set.addLoop(circlePoints(node.centre, toNm(2.0 * (radius - half)), how));
        }
        return;
    }
    // A pen wider than the arc's radius would turn the inner edge inside out: then tracks along the chords, which
    // unite to the same region.
    std::vector<Point> chords;
    discretiseEdge(node, end, how, chords);
    chords.push_back(end);
    if (radius <= half) {
        for (std::size_t i = 0; i + 1 < chords.size(); ++i) {
            addOutline(set, capsulePoints(chords[i], chords[i + 1], width, how));
        }
        return;
    }
    const auto scaled = [&](Point p, double r) {
        const double length = std::hypot(double(p.x) - node.centre.x, double(p.y) - node.centre.y);
        return Point{toNm(node.centre.x + (p.x - double(node.centre.x)) / length * r),
                     toNm(node.centre.y + (p.y - double(node.centre.y)) / length * r)};
    };
    // Counter-clockwise order: outer edge along the sweep, end cap, inner edge back, start cap.
    const EdgeKind along = sweep > 0 ? EdgeKind::ArcCounterClockwise : EdgeKind::ArcClockwise;
    const EdgeKind back = sweep > 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
    const auto radiusAt = [&](Point p) { return std::hypot(double(p.x) - node.centre.x, double(p.y) - node.centre.y); };
    const Point outerStart = scaled(node.point, radiusAt(node.point) + half);
    const Point outerEnd = scaled(end, radiusAt(end) + half);
    const Point innerEnd = scaled(end, radiusAt(end) - half);
    const Point innerStart = scaled(node.point, radiusAt(node.point) - half);
    std::vector<Point> outline;
    discretiseEdge({outerStart, node.centre, along}, outerEnd, how, outline);
    discretiseEdge({outerEnd, end, along}, innerEnd, how, outline);
    discretiseEdge({innerEnd, node.centre, back}, innerStart, how, outline);
    discretiseEdge({innerStart, node.point, along}, outerStart, how, outline);
    addOutline(set, outline);
}

void addTrack(const PathNode& node, Point end, Nm width, const Discretisation& how, PolygonSet& set) {
    if (node.edge == EdgeKind::Line) {
        addOutline(set, capsulePoints(node.point, end, width, how));
    } else {
        addArcTrack(node, end, width, how, set);
    }
}

}  // namespace

PolygonSet discretise(const Document& document, ElementId element, const Discretisation& how) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    const ElementKind kind = document.elements.kind[element.row()];
    if (kind == ElementKind::Area) {
        const AreaGeometry& area = document.areas[row];
        return discretise(document.shapes, area.shape, how, &area.placement);
    }
    PolygonSet set;
    if ((flags & kSquarePen) != 0) {
        addOutline(set, squarePenPoints(document.lines[row]));
        return set;
    }
    forEachTrack(document, element,
                 [&](const PathNode& node, Point end, Nm width, Nm) { addTrack(node, end, width, how, set); });
    const bool isRing = kind == ElementKind::Circle && document.circles[row].innerDiameter > 0 && (flags & kHole) == 0;
    if (isRing && !set.polygons.empty()) {
        set.addLoop(circlePoints(document.circles[row].centre, document.circles[row].innerDiameter, how));
    }
    return set;
}

PolygonSet discretiseOpening(const Document& document, ElementId element, const Discretisation& how) {
    PolygonSet set;
    if ((document.elements.flags[element.row()] & kHole) != 0) {
        forEachTrack(document, element, [&](const PathNode& node, Point end, Nm, Nm innerWidth) {
            if (innerWidth > 0) {
                addTrack(node, end, innerWidth, how, set);
            }
        });
    }
    return set;
}

}  // namespace model
