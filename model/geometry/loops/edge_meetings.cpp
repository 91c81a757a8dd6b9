#include "model/geometry/loops/edge_meetings.h"

#include <cmath>

#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kOneCentreNm = 1e-3;

bool areOpposite(double s, double t) {
    return (s < 0 && t > 0) || (s > 0 && t < 0);
}

Meetings meetLines(const Edge& e, const Edge& f) {
    Meetings found;
    const PointD we = minus(e.b, e.a);
    const PointD wf = minus(f.b, f.a);
    const double ea = cross(wf, minus(e.a, f.a));
    const double eb = cross(wf, minus(e.b, f.a));
    if (areOpposite(ea, eb) && areOpposite(cross(we, minus(f.a, e.a)), cross(we, minus(f.b, e.a)))) {
        const double t = ea / (ea - eb);
        found.add({e.a.x + we.x * t, e.a.y + we.y * t});
    }
    return found;
}

Meetings meetLineAndArc(const Edge& line, const Edge& arc) {
    Meetings found;
    const PointD delta = minus(line.b, line.a);
    const double full = length(delta);
    const PointD toCentre = minus(arc.centre, line.a);
    const double height = cross(delta, toCentre) / full;
    const double squared = (arc.radius - height) * (arc.radius + height);
    if (full == 0.0 || squared < 0.0) {
        return found;
    }
    const double foot = dot(toCentre, delta) / full;
    const double half = std::sqrt(squared);
    for (const double t : {foot - half, foot + half}) {
        const PointD p{line.a.x + delta.x * t / full, line.a.y + delta.y * t / full};
        if (t >= 0 && t <= full && passes(arc, minus(p, arc.centre))) {
            found.add(p);
        }
    }
    return found;
}

Meetings meetArcs(const Edge& e, const Edge& f) {
    Meetings found;
    const PointD delta = minus(f.centre, e.centre);
    const double apart = length(delta);
    if (apart < kOneCentreNm || apart > e.radius + f.radius || apart < std::abs(e.radius - f.radius)) {
        return found;
    }
    const double along = (apart + (e.radius - f.radius) / apart * (e.radius + f.radius)) / 2;
    const double squared = (e.radius - along) * (e.radius + along);
    const double half = squared > 0.0 ? std::sqrt(squared) : 0.0;
    const PointD unit{delta.x / apart, delta.y / apart};
    for (const double side : {-half, half}) {
        const PointD p{e.centre.x + unit.x * along - unit.y * side, e.centre.y + unit.y * along + unit.x * side};
        if (passes(e, minus(p, e.centre)) && passes(f, minus(p, f.centre))) {
            found.add(p);
        }
    }
    return found;
}

}  // namespace

Meetings meetingsOf(const Edge& a, const Edge& b) {
    if (a.isArc()) {
        return b.isArc() ? meetArcs(a, b) : meetLineAndArc(b, a);
    }
    return b.isArc() ? meetLineAndArc(a, b) : meetLines(a, b);
}

double distanceTo(const Edge& edge, PointD p) {
    return length(minus(nearestOn(edge, p), p));
}

}  // namespace model
