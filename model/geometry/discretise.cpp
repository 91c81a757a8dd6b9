#include "model/geometry/discretise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/assert.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kFullCircle = 2.0 * std::numbers::pi;

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
    if (isIdentity(placement)) {
        return polygons;
    }
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
    const double step = tolerance >= radius ? kFullCircle / 8.0
                                            : std::min(kFullCircle / 8.0, 2.0 * std::acos(1.0 - tolerance / radius));
    return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step - 1e-9)));
}

double sweepOf(const PathNode& from, Point to) {
    ASSERT(isArc(from.edge));
    const bool isClockwise = from.edge == EdgeKind::ArcClockwise;
    if (from.point == to) {
        return isClockwise ? -kFullCircle : kFullCircle;
    }
    const double start = std::atan2(double(from.point.y) - from.centre.y, double(from.point.x) - from.centre.x);
    const double end = std::atan2(double(to.y) - from.centre.y, double(to.x) - from.centre.x);
    double sweep = isClockwise ? start - end : end - start;
    sweep -= kFullCircle * std::floor(sweep / kFullCircle);
    return isClockwise ? -sweep : sweep;
}

void discretiseEdge(const PathNode& from, Point to, const Discretisation& how, std::vector<Point>& out) {
    ASSERT(from.edge != EdgeKind::Curve);
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

std::vector<PointD> paperPoints(std::span<const Bezier> pieces) {
    std::vector<PointD> points{pieces.front().start()};
    for (const Bezier& piece : pieces) {
        for (int i = 1; i <= Discretisation::kPaperArcSegments; ++i) {
            const double t = static_cast<double>(i) / Discretisation::kPaperArcSegments;
            points.push_back(piece.at(piece.from() + (piece.to() - piece.from()) * t).point);
        }
    }
    return points;
}

std::vector<PointD> pointsAlong(const NurbsView& curve, const Discretisation& how) {
    constexpr double kRounding = 1.0;  // nm: points are rounded to whole nanometres afterwards
    const std::vector<Bezier> pieces = bezierPieces(curve);
    const double tolerance = std::clamp(how.chordToleranceNm, Discretisation::kMinChordNm, Discretisation::kMaxChordNm);
    return how.paperSegments ? paperPoints(pieces) : chordPoints(pieces, tolerance - kRounding, kFullCircle / 8.0);
}

}  // namespace

void discretiseEdge(const PathNodes& path, std::size_t node, const Discretisation& how, std::vector<Point>& out) {
    if (path[node].edge != EdgeKind::Curve) {
        return discretiseEdge(path[node], path.endOf(node), how, out);
    }
    const std::vector<PointD> points = pointsAlong(path.curveAt(node), how);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        out.push_back({toNm(points[i].x), toNm(points[i].y)});
    }
}

namespace {

void discretiseLoop(const PathNodes& path, const Discretisation& how, std::vector<Point>& out) {
    out.clear();
    for (std::size_t i = 0; i < path.size(); ++i) {
        discretiseEdge(path, i, how, out);
    }
}

}  // namespace

PolygonSet discretise(const ShapeTable& shapes, ShapeId shape, const Discretisation& how, const Placement* placement) {
    PolygonSet set;
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
    return set;
}

}  // namespace model
