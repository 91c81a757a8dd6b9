#include "model/geometry/discretise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/assert.h"

namespace model {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Nm toNm(double value) {
    return static_cast<Nm>(std::llround(value));
}

}  // namespace

__int128 twiceArea(std::span<const Point> loop) {
    __int128 sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point& a = loop[i];
        const Point& b = loop[i + 1 < loop.size() ? i + 1 : 0];
        // |x|, |y| <= 2^31, so each product fits 62 bits and the difference 63.
        sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
    }
    return sum;
}

__int128 twiceArea(const PolygonSet& set) {
    __int128 sum = 0;
    for (std::size_t i = 0; i < set.loopCount(); ++i) {
        sum += twiceArea(set.loop(i));
    }
    return sum;
}

bool PolygonSet::addLoop(std::span<const Point> loop) {
    ASSERT(!polygons.empty());
    if (loopStart.empty()) {
        loopStart.push_back(0);
    }
    const std::size_t first = points.size();
    for (const Point& point : loop) {
        if (points.size() == first || points.back() != point) {
            points.push_back(point);
        }
    }
    while (points.size() > first + 1 && points.back() == points[first]) {
        points.pop_back();
    }
    if (points.size() - first < 3) {
        points.resize(first);
        return false;
    }
    const bool isOutline = polygons.back().loopCount == 0;
    const bool isCounterClockwise = twiceArea(std::span(points).subspan(first)) > 0;
    if (isOutline != isCounterClockwise) {
        std::reverse(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
    }
    loopStart.push_back(static_cast<std::uint32_t>(points.size()));
    ++polygons.back().loopCount;
    return true;
}

void PolygonSet::append(const PolygonSet& other) {
    if (loopStart.empty()) {
        loopStart.push_back(0);
    }
    const auto pointShift = static_cast<std::uint32_t>(points.size());
    const auto loopShift = static_cast<std::uint32_t>(loopCount());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (std::size_t i = 1; i < other.loopStart.size(); ++i) {
        loopStart.push_back(other.loopStart[i] + pointShift);
    }
    for (const Polygon& polygon : other.polygons) {
        polygons.push_back({polygon.firstLoop + loopShift, polygon.loopCount});
    }
}

PolygonSet placed(const PolygonSet& polygons, const Placement& placement) {
    PolygonSet result;
    std::vector<Point> points;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        result.beginPolygon();
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            points.clear();
            for (const Point& point : polygons.loop(polygon.firstLoop + i)) {
                points.push_back(placement.apply(point));
            }
            result.addLoop(points);
        }
    }
    return result;
}

ShapeSketch sketchOf(const PolygonSet& polygons) {
    ShapeSketch sketch;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            sketch.addPolygon(polygons.loop(polygon.firstLoop + i), i > 0);
        }
    }
    return sketch;
}

int chordCount(double radius, double sweep, bool isFullCircle, const Discretisation& how) {
    if (how.paperSegments) {
        return isFullCircle ? Discretisation::kPaperCircleSegments : Discretisation::kPaperArcSegments;
    }
    // The sagitta of a chord over the angle t is r(1 - cos(t/2)); at least an octagon, so that tiny circles stay round.
    const double tolerance = std::clamp(how.chordToleranceNm, Discretisation::kMinChordNm, Discretisation::kMaxChordNm);
    const double step =
        tolerance >= radius ? kTurn / 8.0 : std::min(kTurn / 8.0, 2.0 * std::acos(1.0 - tolerance / radius));
    return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step - 1e-9)));
}

double sweepOf(const PathNode& from, Point to) {
    ASSERT(from.edge != EdgeKind::Line);
    const bool isClockwise = from.edge == EdgeKind::ArcClockwise;
    if (from.point == to) {
        return isClockwise ? -kTurn : kTurn;
    }
    const double start = std::atan2(double(from.point.y) - from.centre.y, double(from.point.x) - from.centre.x);
    const double end = std::atan2(double(to.y) - from.centre.y, double(to.x) - from.centre.x);
    double sweep = isClockwise ? start - end : end - start;
    sweep -= kTurn * std::floor(sweep / kTurn);
    return isClockwise ? -sweep : sweep;
}

void discretiseEdge(const PathNode& from, Point to, const Discretisation& how, std::vector<Point>& out) {
    out.push_back(from.point);
    if (from.edge == EdgeKind::Line) {
        return;
    }
    const double x = from.centre.x;
    const double y = from.centre.y;
    const double startRadius = std::hypot(from.point.x - x, from.point.y - y);
    const double endRadius = std::hypot(to.x - x, to.y - y);
    const double start = std::atan2(from.point.y - y, from.point.x - x);
    const double sweep = sweepOf(from, to);
    const int chords = chordCount(std::max(startRadius, endRadius), sweep, from.point == to, how);
    for (int i = 1; i < chords; ++i) {
        const double t = static_cast<double>(i) / chords;
        const double radius = startRadius + (endRadius - startRadius) * t;
        const double angle = start + sweep * t;
        out.push_back({toNm(x + radius * std::cos(angle)), toNm(y + radius * std::sin(angle))});
    }
}

namespace {

void discretiseLoop(std::span<const PathNode> nodes, const Discretisation& how, std::vector<Point>& out) {
    out.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        discretiseEdge(nodes[i], nodes[i + 1 < nodes.size() ? i + 1 : 0].point, how, out);
    }
}

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

/// The region of a round pen along a straight stroke, counter-clockwise.
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
    // extreme corners on either side of the stroke.
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

void addArcStroke(const PathNode& node, Point end, Nm width, const Discretisation& how, PolygonSet& set) {
    const double sweep = sweepOf(node, end);
    const double radius = std::hypot(double(node.point.x) - node.centre.x, double(node.point.y) - node.centre.y);
    const double half = width / 2.0;
    if (std::abs(sweep) >= kTurn) {
        set.beginPolygon();
        set.addLoop(circlePoints(node.centre, toNm(2.0 * (radius + half)), how));
        if (radius > half) {
            set.addLoop(circlePoints(node.centre, toNm(2.0 * (radius - half)), how));
        }
        return;
    }
    // A pen wider than the arc's radius would turn the inner edge inside out: then strokes along the chords, which
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

void addStroke(const PathNode& node, Point end, Nm width, const Discretisation& how, PolygonSet& set) {
    if (node.edge == EdgeKind::Line) {
        addOutline(set, capsulePoints(node.point, end, width, how));
    } else {
        addArcStroke(node, end, width, how, set);
    }
}

void discretiseContours(const ShapeTable& shapes, ShapeId shape, const Placement* placement, const Discretisation& how,
                        PolygonSet& set) {
    std::vector<Point> loop;
    bool hasOutline = false;
    for (const Contour& contour : shapes.contoursOf(shape)) {
        discretiseLoop(shapes.nodesOf(contour), how, loop);
        if (placement != nullptr) {
            for (Point& point : loop) {
                point = placement->apply(point);
            }
        }
        if (!contour.isHole) {
            set.beginPolygon();
            hasOutline = set.addLoop(loop);
            if (!hasOutline) {
                set.polygons.pop_back();
            }
        } else if (hasOutline) {
            set.addLoop(loop);
        }
    }
}

}  // namespace

PolygonSet discretise(const ShapeTable& shapes, ShapeId shape, const Discretisation& how) {
    PolygonSet set;
    discretiseContours(shapes, shape, nullptr, how, set);
    return set;
}

PolygonSet discretise(const Document& document, ElementId element, const Discretisation& how) {
    PolygonSet set;
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            const bool isSquare = (document.elements.flags[element.row()] & kSquarePen) != 0;
            addOutline(set, isSquare ? squarePenPoints(line) : capsulePoints(line.a, line.b, line.width, how));
            break;
        }
        case ElementKind::Arc:
            addArcStroke(document.arcs[row].node, document.arcs[row].end, document.arcs[row].width, how, set);
            break;
        case ElementKind::Circle: {
            const CircleGeometry& circle = document.circles[row];
            addOutline(set, circlePoints(circle.centre, circle.diameter, how));
            const bool isHole = (document.elements.flags[element.row()] & kHole) != 0;
            if (circle.innerDiameter > 0 && !isHole && !set.polygons.empty()) {
                set.addLoop(circlePoints(circle.centre, circle.innerDiameter, how));
            }
            break;
        }
        case ElementKind::Trail: {
            const std::span<const PathNode> nodes = document.nodesOf(document.trails[row]);
            const std::span<const Nm> widths = document.widthsOf(document.trails[row]);
            for (std::size_t i = 0; i < widths.size(); ++i) {
                addStroke(nodes[i], nodes[i + 1].point, widths[i], how, set);
            }
            break;
        }
        case ElementKind::Area: {
            const AreaGeometry& area = document.areas[row];
            discretiseContours(document.shapes, area.shape, &area.placement, how, set);
            break;
        }
    }
    return set;
}

PolygonSet discretiseOpening(const Document& document, ElementId element, const Discretisation& how) {
    PolygonSet set;
    const std::uint32_t row = document.elements.geometry[element.row()];
    const bool isHole = (document.elements.flags[element.row()] & kHole) != 0;
    const ElementKind kind = isHole ? document.elements.kind[element.row()] : ElementKind::Area;
    if (kind == ElementKind::Circle && document.circles[row].innerDiameter > 0) {
        addOutline(set, circlePoints(document.circles[row].centre, document.circles[row].innerDiameter, how));
    } else if (kind == ElementKind::Line && document.lines[row].innerWidth > 0) {
        const LineGeometry& line = document.lines[row];
        addOutline(set, capsulePoints(line.a, line.b, line.innerWidth, how));
    } else if (kind == ElementKind::Arc && document.arcs[row].innerWidth > 0) {
        addArcStroke(document.arcs[row].node, document.arcs[row].end, document.arcs[row].innerWidth, how, set);
    } else if (kind == ElementKind::Trail && document.trails[row].innerWidth > 0) {
        const std::span<const PathNode> nodes = document.nodesOf(document.trails[row]);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            addStroke(nodes[i], nodes[i + 1].point, document.trails[row].innerWidth, how, set);
        }
    }
    return set;
}

}  // namespace model
