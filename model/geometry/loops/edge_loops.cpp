#include "model/geometry/loops/edge_loops.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/curve_edges.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

Edge lineFrom(PointD a, PointD b) {
    Edge edge;
    edge.a = a;
    edge.b = b;
    return edge;
}

Edge arcFrom(PointD a, PointD b, PointD centre, bool isClockwise) {
    Edge edge = lineFrom(a, b);
    edge.centre = centre;
    edge.radius = distance(a, centre);
    edge.isClockwise = isClockwise;
    return edge;
}

/// The point of the perpendicular bisector of `a` and `b` that is nearest to `centre`.
PointD ontoBisector(PointD a, PointD b, PointD centre) {
    const PointD chord = minus(b, a);
    const double squared = dot(chord, chord);
    const PointD middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double along = dot(minus(centre, middle), chord) / squared;
    return {centre.x - along * chord.x, centre.y - along * chord.y};
}

double signedArea(std::span<const Edge> loop) {
    const PointD base = loop.front().a;
    double area = 0.0;
    for (const Edge& edge : loop) {
        area += areaUnder(edge, base);
    }
    return area;
}

Nurbs reversed(Nurbs curve) {
    std::ranges::reverse(curve.controls);
    std::ranges::reverse(curve.knots);
    const double sum = curve.knots.front() + curve.knots.back();
    for (double& knot : curve.knots) {
        knot = sum - knot;
    }
    return curve;
}

/// Those of the loop that begins with the edge `first`.
void turnCurvesRound(std::vector<EdgeLoops::CurveRun>& curves, std::uint32_t first, std::uint32_t count) {
    const auto isOfLoop = [=](const EdgeLoops::CurveRun& run) {
        return first <= run.firstEdge && run.firstEdge < first + count;
    };
    for (EdgeLoops::CurveRun& run : curves) {
        if (isOfLoop(run)) {
            run.firstEdge = first + (first + count - run.firstEdge - run.edgeCount);
            run.curve = reversed(std::move(run.curve));
        }
    }
    std::ranges::sort(curves, {}, &EdgeLoops::CurveRun::firstEdge);
}

void turnRound(std::span<Edge> loop) {
    std::ranges::reverse(loop);
    for (Edge& edge : loop) {
        edge = reversed(edge);
    }
}

}  // namespace

Edge reversed(const Edge& edge) {
    Edge other = edge;
    std::swap(other.a, other.b);
    other.isClockwise = !edge.isClockwise;
    return other;
}

void EdgeLoops::clear() {
    edges.clear();
    loopStart.assign(1, 0);
    curves.clear();
}

void EdgeLoops::addCurve(const NurbsView& curve) {
    CurveRun run{static_cast<std::uint32_t>(edges.size()), 0, {curve.degree, {}, {}}};
    for (const Edge& edge : edgesOf(curve)) {
        edges.push_back(edge);
    }
    run.edgeCount = static_cast<std::uint32_t>(edges.size()) - run.firstEdge;
    run.curve.knots.assign(curve.knots.begin(), curve.knots.end());
    run.curve.controls.assign(curve.controls.begin(), curve.controls.end());
    curves.push_back(std::move(run));
}

void EdgeLoops::addLine(PointD a, PointD b) {
    if (a != b) {
        edges.push_back(lineFrom(a, b));
    }
}

void EdgeLoops::addArc(PointD a, PointD b, PointD centre, bool isClockwise) {
    if (a == b) {
        return;
    }
    const double mismatch = std::abs(distance(a, centre) - distance(b, centre));
    const PointD moved = ontoBisector(a, b, centre);
    if (distance(moved, centre) <= 4 * mismatch + 1.0) {
        edges.push_back(arcFrom(a, b, moved, isClockwise));
        return;
    }
    const double scale = distance(a, centre) / distance(b, centre);
    const PointD end{centre.x + (b.x - centre.x) * scale, centre.y + (b.y - centre.y) * scale};
    edges.push_back(arcFrom(a, end, centre, isClockwise));
    addLine(end, b);
}

bool EdgeLoops::endLoop() {
    const std::span<Edge> loop = std::span(edges).subspan(loopStart.back());
    const double area = loop.empty() ? 0.0 : signedArea(loop);
    if (area == 0.0) {
        edges.resize(loopStart.back());
        std::erase_if(curves, [this](const CurveRun& run) { return run.firstEdge >= edges.size(); });
        return false;
    }
    const bool isHole = loopCount() > 0;
    if ((area > 0.0) == isHole) {
        turnRound(loop);
        turnCurvesRound(curves, loopStart.back(), static_cast<std::uint32_t>(loop.size()));
    }
    for (Edge& edge : loop) {
        edge.isHole = isHole;
        edge.winding = isHole ? -1 : 1;
    }
    loopStart.push_back(static_cast<std::uint32_t>(edges.size()));
    return true;
}

void EdgeLoops::addCircle(PointD centre, double radius) {
    Edge circle;
    circle.a = circle.b = {centre.x + radius, centre.y};
    circle.centre = centre;
    circle.radius = radius;
    edges.push_back(circle);
    endLoop();
}

void EdgeLoops::addCapsule(PointD a, PointD b, double radius) {
    const double full = distance(a, b);
    if (full == 0.0) {
        return addCircle(a, radius);
    }
    const PointD left{-(b.y - a.y) / full * radius, (b.x - a.x) / full * radius};
    const PointD rightOfA{a.x - left.x, a.y - left.y};
    const PointD rightOfB{b.x - left.x, b.y - left.y};
    const PointD leftOfA{a.x + left.x, a.y + left.y};
    const PointD leftOfB{b.x + left.x, b.y + left.y};
    addLine(rightOfA, rightOfB);
    addArc(rightOfB, leftOfB, b, false);
    addLine(leftOfB, leftOfA);
    addArc(leftOfA, rightOfA, a, false);
    endLoop();
}

double areaOf(const EdgeLoops& loops) {
    double area = 0.0;
    for (std::size_t i = 0; i < loops.loopCount(); ++i) {
        area += signedArea(loops.loop(i));
    }
    return area;
}

EdgeLoops placed(const EdgeLoops& loops, const Placement& placement) {
    EdgeLoops moved = loops;
    for (Edge& edge : moved.edges) {
        edge = placed(edge, placement);
    }
    for (EdgeLoops::CurveRun& run : moved.curves) {
        for (ControlPoint& control : run.curve.controls) {
            control.at = placement.apply(control.at);
        }
    }
    if (placement.isMirrored) {
        for (std::size_t i = 0; i < moved.loopCount(); ++i) {
            const std::uint32_t first = moved.loopStart[i];
            const std::uint32_t count = moved.loopStart[i + 1] - first;
            turnRound(std::span(moved.edges).subspan(first, count));
            turnCurvesRound(moved.curves, first, count);
        }
    }
    for (Edge& edge : moved.edges) {
        edge.winding = edge.isHole ? -1 : 1;
    }
    return moved;
}

const EdgeLoops::CurveRun* curveAt(const EdgeLoops& loops, std::size_t row) {
    const auto found = std::ranges::lower_bound(loops.curves, row, {}, &EdgeLoops::CurveRun::firstEdge);
    return found != loops.curves.end() && found->firstEdge == row ? &*found : nullptr;
}

Box boxOf(const EdgeLoops& loops) {
    Box box;
    for (const Edge& edge : loops.edges) {
        box.include(boxOf(edge));
    }
    return box;
}

}  // namespace model
