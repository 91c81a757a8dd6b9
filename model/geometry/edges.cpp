#include "model/geometry/edges.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/base/assert.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

PointD along(PointD from, PointD delta, double t) {
    return {from.x + delta.x * t, from.y + delta.y * t};
}

/// The arc's ends seen from its centre, in counter-clockwise order.
std::array<PointD, 2> counterClockwiseEnds(const Edge& arc) {
    const PointD u = minus(arc.a, arc.centre);
    const PointD w = minus(arc.b, arc.centre);
    return arc.isClockwise ? std::array{w, u} : std::array{u, w};
}

}  // namespace

bool passes(const Edge& arc, PointD v) {
    if (arc.isFullCircle()) {
        return true;
    }
    const auto [u, w] = counterClockwiseEnds(arc);
    const double angle = cross(u, w);
    const bool isBehindStart = cross(u, v) >= 0;
    const bool isBeforeEnd = cross(v, w) >= 0;
    if (angle == 0 && dot(u, w) > 0) {
        return false;  // both ends in one direction: nothing lies between them
    }
    const bool isAtMostHalf = angle >= 0;
    return isAtMostHalf ? isBehindStart && isBeforeEnd : isBehindStart || isBeforeEnd;
}

namespace {

/// The shortest connection found so far between the middles of two edges.
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    PointD p;
    PointD q;

    void offer(PointD onFirst, PointD onSecond) {
        const PointD delta = minus(onFirst, onSecond);
        const double d = dot(delta, delta);
        if (d < squared) {
            *this = {d, onFirst, onSecond};
        }
    }
    [[nodiscard]] Nearest swapped() const { return {squared, q, p}; }
};

PointD nearestOnLine(const Edge& line, PointD p) {
    const PointD delta = minus(line.b, line.a);
    const double squared = dot(delta, delta);
    if (squared == 0) {
        return line.a;
    }
    const double t = dot(minus(p, line.a), delta) / squared;
    return t <= 0 ? line.a : t >= 1 ? line.b : along(line.a, delta, t);
}

PointD nearestOnArc(const Edge& arc, PointD p) {
    const PointD v = minus(p, arc.centre);
    const double distance = length(v);
    if (distance > 0 && passes(arc, v)) {
        return along(arc.centre, v, arc.radius / distance);
    }
    const PointD toA = minus(p, arc.a);
    const PointD toB = minus(p, arc.b);
    return dot(toA, toA) <= dot(toB, toB) ? arc.a : arc.b;
}

}  // namespace

PointD nearestOn(const Edge& edge, PointD p) {
    return edge.isArc() ? nearestOnArc(edge, p) : nearestOnLine(edge, p);
}

namespace {

void offerEnds(const Edge& e, const Edge& f, Nearest& nearest) {
    nearest.offer(e.a, nearestOn(f, e.a));
    nearest.offer(e.b, nearestOn(f, e.b));
    nearest.offer(nearestOn(e, f.a), f.a);
    nearest.offer(nearestOn(e, f.b), f.b);
}

Nearest lineToLine(const Edge& e, const Edge& f) {
    Nearest nearest;
    const PointD we = minus(e.b, e.a);
    const PointD wf = minus(f.b, f.a);
    const double fa = cross(we, minus(f.a, e.a));
    const double fb = cross(we, minus(f.b, e.a));
    const double ea = cross(wf, minus(e.a, f.a));
    const double eb = cross(wf, minus(e.b, f.a));
    if (((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) && ((ea < 0 && eb > 0) || (ea > 0 && eb < 0))) {
        const PointD crossing = along(e.a, we, ea / (ea - eb));
        nearest.offer(crossing, crossing);
        return nearest;
    }
    offerEnds(e, f, nearest);
    return nearest;
}

/// Calls `meet` for the points where a line meets an arc.
template <class Meet>
void meetLineAndArc(const Edge& line, const Edge& arc, const Meet& meet) {
    const PointD delta = minus(line.b, line.a);
    const double full = length(delta);
    if (full == 0) {
        return;
    }
    const PointD unit = {delta.x / full, delta.y / full};
    const PointD toCentre = minus(arc.centre, line.a);
    const double foot = dot(toCentre, unit);
    const double height = cross(unit, toCentre);
    const double halfSquared = (arc.radius - height) * (arc.radius + height);
    if (halfSquared < 0) {
        return;
    }
    for (const double t : {foot - std::sqrt(halfSquared), foot + std::sqrt(halfSquared)}) {
        const PointD crossing = along(line.a, unit, t);
        if (t >= 0 && t <= full && passes(arc, minus(crossing, arc.centre))) {
            meet(crossing);
        }
    }
}

Nearest lineToArc(const Edge& line, const Edge& arc) {
    Nearest nearest;
    meetLineAndArc(line, arc, [&](PointD crossing) { nearest.offer(crossing, crossing); });
    if (nearest.squared > 0) {
        offerEnds(line, arc, nearest);
        const PointD foot = nearestOnLine(line, arc.centre);
        nearest.offer(foot, nearestOnArc(arc, foot));
    }
    return nearest;
}

/// Calls `meet` for the points where two arcs meet.
template <class Meet>
void meetArcs(const Edge& e, const Edge& f, const Meet& meet) {
    const PointD delta = minus(f.centre, e.centre);
    const double apart = length(delta);
    if (apart == 0) {
        return;
    }
    const PointD unit = {delta.x / apart, delta.y / apart};
    const double x = (apart * apart + (e.radius - f.radius) * (e.radius + f.radius)) / (2 * apart);
    const double squared = (e.radius - x) * (e.radius + x);
    for (const double y : {std::sqrt(std::max(squared, 0.0)), -std::sqrt(std::max(squared, 0.0))}) {
        const PointD meeting = {e.centre.x + unit.x * x - unit.y * y, e.centre.y + unit.y * x + unit.x * y};
        if (squared >= 0 && passes(e, minus(meeting, e.centre)) && passes(f, minus(meeting, f.centre))) {
            meet(meeting);
        }
    }
}

/// Offers the points where two arcs meet, and those on the line through both centres.
void offerAcrossCentres(const Edge& e, const Edge& f, Nearest& nearest) {
    const PointD delta = minus(f.centre, e.centre);
    const double apart = length(delta);
    if (apart == 0) {
        return;  // concentric: the ends tell
    }
    const PointD unit = {delta.x / apart, delta.y / apart};
    for (const double side : {1.0, -1.0}) {
        const PointD v = {unit.x * side, unit.y * side};
        if (passes(e, v)) {
            const PointD p = along(e.centre, v, e.radius);
            nearest.offer(p, nearestOnArc(f, p));
        }
        if (passes(f, v)) {
            const PointD q = along(f.centre, v, f.radius);
            nearest.offer(nearestOnArc(e, q), q);
        }
    }
    meetArcs(e, f, [&](PointD meeting) { nearest.offer(meeting, meeting); });
}

Nearest arcToArc(const Edge& e, const Edge& f) {
    Nearest nearest;
    offerEnds(e, f, nearest);
    offerAcrossCentres(e, f, nearest);
    return nearest;
}

Nearest nearestBetween(const Edge& a, const Edge& b) {
    if (a.isArc()) {
        return b.isArc() ? arcToArc(a, b) : lineToArc(b, a).swapped();
    }
    return b.isArc() ? lineToArc(a, b) : lineToLine(a, b);
}

/// On which side of the chord: positive left. Points on it are taken as moved right by nothing, then up by less.
double sideOf(const Edge& edge, PointD p) {
    const PointD delta = minus(edge.b, edge.a);
    const double side = cross(delta, minus(p, edge.a));
    return side != 0 ? side : delta.y != 0 ? -delta.y : delta.x;
}

Nm floored(double value) {
    return static_cast<Nm>(std::floor(value));
}

Nm ceiled(double value) {
    return static_cast<Nm>(std::ceil(value));
}

}  // namespace

Edge edgeOf(const PathNode& from, Point to) {
    ASSERT(from.edge != EdgeKind::Curve);
    Edge edge;
    edge.a = base::toDouble(from.point);
    edge.b = base::toDouble(to);
    if (from.edge != EdgeKind::Line) {
        edge.centre = base::toDouble(from.centre);
        edge.radius = (length(minus(edge.a, edge.centre)) + length(minus(edge.b, edge.centre))) / 2;
        edge.isClockwise = from.edge == EdgeKind::ArcClockwise;
    }
    return edge;
}

PointD unplaced(PointD p, const Placement& placement) {
    const double angle = placement.clockwiseDeg * std::numbers::pi / 180.0;
    const double x = (placement.isMirrored ? -1.0 : 1.0) * (p.x - placement.origin.x);
    const double y = p.y - placement.origin.y;
    return {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
}

Edge placed(const Edge& edge, const Placement& placement) {
    Edge moved = edge;
    moved.a = placement.apply(edge.a);
    moved.b = edge.isFullCircle() ? moved.a : placement.apply(edge.b);
    moved.centre = placement.apply(edge.centre);
    moved.isClockwise = edge.isClockwise != placement.isMirrored;
    return moved;
}

Box boxOf(const Edge& edge) {
    double reach[4] = {std::max(edge.a.x, edge.b.x), std::max(edge.a.y, edge.b.y), -std::min(edge.a.x, edge.b.x),
                       -std::min(edge.a.y, edge.b.y)};
    if (edge.isArc()) {
        const PointD c = edge.centre;
        const double r = edge.radius;
        const double limit[4] = {c.x + r, c.y + r, r - c.x, r - c.y};
        constexpr PointD kAxes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        for (int i = 0; i < 4; ++i) {
            reach[i] = passes(edge, kAxes[i]) ? std::max(reach[i], limit[i]) : reach[i];
        }
    }
    const double pen = edge.pen;
    return {{floored(-reach[2] - pen), floored(-reach[3] - pen)}, {ceiled(reach[0] + pen), ceiled(reach[1] + pen)}};
}

Spacing spacingBetween(const Edge& a, const Edge& b) {
    const Nearest nearest = nearestBetween(a, b);
    const double middles = std::sqrt(nearest.squared);
    const PointD delta = minus(nearest.q, nearest.p);
    const double distance = middles - a.pen - b.pen;
    if (distance > 0) {
        return {distance, along(nearest.p, delta, a.pen / middles), along(nearest.q, delta, -b.pen / middles)};
    }
    // The middle of what both cover on the line from one middle to the other.
    const double from = std::max(middles - b.pen, 0.0);
    const double to = std::min(a.pen, middles);
    const PointD location = middles > 0 ? along(nearest.p, delta, (from + to) / 2 / middles) : nearest.p;
    return {0.0, location, location};
}

std::vector<PointD> crossingsOf(const Edge& a, const Edge& b) {
    std::vector<PointD> crossings;
    const auto meet = [&](PointD p) { crossings.push_back(p); };
    if (a.isArc() && b.isArc()) {
        meetArcs(a, b, meet);
    } else if (a.isArc()) {
        meetLineAndArc(b, a, meet);
    } else if (b.isArc()) {
        meetLineAndArc(a, b, meet);
    } else if (cross(minus(a.b, a.a), minus(b.b, b.a)) != 0) {
        const Nearest nearest = lineToLine(a, b);
        if (nearest.squared < 0.25) {  // ends on the other line are rounded to whole nanometres
            meet(nearest.p);
        }
    }
    return crossings;
}

namespace {

/// The angle from one direction to another, 0 to 2π, counter-clockwise.
double angleTo(PointD from, PointD to) {
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// How far an arc has turned when it comes by a point, 0 to 2π.
double turnTo(const Edge& arc, PointD on) {
    const PointD start = minus(arc.a, arc.centre);
    const PointD end = minus(on, arc.centre);
    return arc.isClockwise ? angleTo(end, start) : angleTo(start, end);
}

}  // namespace

double lengthTo(const Edge& edge, PointD on) {
    if (!edge.isArc()) {
        return length(minus(on, edge.a));
    }
    const double turn = turnTo(edge, on);
    if (edge.isFullCircle()) {
        return edge.radius * turn;
    }
    // By rounding a point may lie a little beyond either end; before the first one it would seem nearly once around.
    const double whole = turnTo(edge, edge.b);
    const bool isBeforeStart = turn > whole && 2 * std::numbers::pi - turn < turn - whole;
    return edge.radius * (isBeforeStart ? 0.0 : std::min(turn, whole));
}

double lengthOf(const Edge& edge) {
    return edge.isFullCircle() ? 2 * std::numbers::pi * edge.radius : lengthTo(edge, edge.b);
}

PointD pointAt(const Edge& edge, double delta) {
    if (!edge.isArc()) {
        const double full = lengthOf(edge);
        return full > 0 ? along(edge.a, minus(edge.b, edge.a), delta / full) : edge.a;
    }
    const double angle = (edge.isClockwise ? -delta : delta) / edge.radius;
    const PointD v = minus(edge.a, edge.centre);
    return {edge.centre.x + v.x * std::cos(angle) - v.y * std::sin(angle),
            edge.centre.y + v.x * std::sin(angle) + v.y * std::cos(angle)};
}

int windingAround(const Edge& edge, PointD p) {
    int winding = 0;
    const double side = sideOf(edge, p);
    if ((edge.a.y > p.y) != (edge.b.y > p.y)) {
        const bool isUp = edge.b.y > edge.a.y;
        winding += isUp && side > 0 ? 1 : !isUp && side < 0 ? -1 : 0;
    }
    if (edge.isArc() && length(minus(p, edge.centre)) <= edge.radius) {
        const bool isBetween = edge.isFullCircle() || (edge.isClockwise ? side > 0 : side < 0);
        winding += !isBetween ? 0 : edge.isClockwise ? -1 : 1;
    }
    return winding;
}

double areaUnder(const Edge& edge, PointD base) {
    const double triangle = cross(minus(edge.a, base), minus(edge.b, base)) / 2;
    if (!edge.isArc()) {
        return triangle;
    }
    const auto [u, w] = counterClockwiseEnds(edge);
    double sweep = std::atan2(cross(u, w), dot(u, w));
    sweep = edge.isFullCircle() ? 2 * std::numbers::pi : sweep < 0 ? sweep + 2 * std::numbers::pi : sweep;
    const double segment = edge.radius * edge.radius * (sweep - std::sin(sweep)) / 2;
    return triangle + (edge.isClockwise ? -segment : segment);
}

}  // namespace model
