#include "model/solids/shells/arc_shell.h"

#include <cmath>
#include <numbers>

#include "model/geometry/discretise.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

PointD outwards(PointD centre, PointD p, double radius) {
    const PointD v = minus(p, centre);
    const double scale = radius / length(v);
    return {centre.x + v.x * scale, centre.y + v.y * scale};
}

/// The track's middle as one true circle, counter-clockwise from `a` to `b`.
Edge middleOf(const ArcGeometry& arc) {
    EdgeLoops loops;
    loops.addArc(toDouble(arc.node.point), toDouble(arc.end), toDouble(arc.node.centre),
                 arc.node.edge == EdgeKind::ArcClockwise);
    return loops.edges.front().isClockwise ? reversed(loops.edges.front()) : loops.edges.front();
}

EdgeLoops ringAround(const ArcGeometry& arc, double pen) {
    const PointD centre = toDouble(arc.node.centre);
    const double radius = distance(toDouble(arc.node.point), centre);
    EdgeLoops loops;
    loops.addCircle(centre, radius + pen);
    if (radius > pen) {
        loops.addCircle(centre, radius - pen);
    }
    return loops;
}

void addOutline(EdgeLoops& loops, const Edge& middle, double pen) {
    const PointD outerA = outwards(middle.centre, middle.a, middle.radius + pen);
    const PointD outerB = outwards(middle.centre, middle.b, middle.radius + pen);
    const PointD innerA = outwards(middle.centre, middle.a, middle.radius - pen);
    const PointD innerB = outwards(middle.centre, middle.b, middle.radius - pen);
    loops.addArc(outerA, outerB, middle.centre, false);
    loops.addArc(outerB, innerB, middle.b, false);
    loops.addArc(innerB, innerA, middle.centre, true);
    loops.addArc(innerA, outerA, middle.a, false);
    loops.endLoop();
}

/// Where the pen reaches over the centre, its round ends meet behind it.
void addFilledOutline(EdgeLoops& loops, const Edge& middle, double pen) {
    const PointD outerA = outwards(middle.centre, middle.a, middle.radius + pen);
    const PointD outerB = outwards(middle.centre, middle.b, middle.radius + pen);
    const PointD chord = minus(middle.b, middle.a);
    const double half = length(chord) / 2;
    const double behind = std::sqrt((pen - half) * (pen + half));
    const PointD meeting{(middle.a.x + middle.b.x) / 2 - chord.y / (2 * half) * behind,
                         (middle.a.y + middle.b.y) / 2 + chord.x / (2 * half) * behind};
    loops.addArc(outerA, outerB, middle.centre, false);
    loops.addArc(outerB, meeting, middle.b, false);
    loops.addArc(meeting, outerA, middle.a, false);
    loops.endLoop();
}

/// Do the round ends overlap other parts of the track, so that its outline crosses itself?
bool overlapsItself(const Edge& middle, double sweep, double pen) {
    return sweep > std::numbers::pi && (middle.radius <= pen || distance(middle.a, middle.b) <= 2 * pen);
}

void add(EdgeLoops& loops, const Edge& middle, double pen) {
    if (middle.radius > pen) {
        addOutline(loops, middle, pen);
    } else {
        addFilledOutline(loops, middle, pen);
    }
}

std::vector<EdgeLoops> halvesOf(const Edge& middle, double pen) {
    Edge first = middle;
    first.b = outwards(middle.centre, pointAt(middle, lengthOf(middle) / 2), middle.radius);
    Edge second = middle;
    second.a = first.b;
    std::vector<EdgeLoops> halves(2);
    add(halves[0], first, pen);
    add(halves[1], second, pen);
    return halves;
}

std::optional<std::vector<EdgeLoops>> unitedHalves(const ArcGeometry& arc, double pen) {
    return arc.node.point == arc.end ? std::optional(std::vector{ringAround(arc, pen)})
                                     : unite(halvesOf(middleOf(arc), pen));
}

}  // namespace

std::optional<EdgeLoops> arcOutline(const ArcGeometry& arc) {
    const double pen = arc.width / 2.0;
    if (arc.width <= 0 || arc.innerWidth >= arc.width) {
        return EdgeLoops{};
    }
    if (arc.node.point == arc.end) {
        return arc.innerWidth > 0 ? std::nullopt : std::optional(ringAround(arc, pen));
    }
    const Edge middle = middleOf(arc);
    if (overlapsItself(middle, std::abs(sweepOf(arc.node, arc.end)), pen)) {
        return std::nullopt;
    }
    EdgeLoops loops;
    add(loops, middle, pen);
    if (arc.innerWidth > 0) {
        add(loops, middle, arc.innerWidth / 2.0);
    }
    return loops;
}

std::optional<std::vector<EdgeLoops>> arcOutlines(const ArcGeometry& arc) {
    if (std::optional<EdgeLoops> outline = arcOutline(arc)) {
        return outline->loopCount() > 0 ? std::vector{std::move(*outline)} : std::vector<EdgeLoops>{};
    }
    std::optional<std::vector<EdgeLoops>> outer = unitedHalves(arc, arc.width / 2.0);
    if (!outer || arc.innerWidth <= 0) {
        return outer;
    }
    const std::optional<std::vector<EdgeLoops>> inner = unitedHalves(arc, arc.innerWidth / 2.0);
    return inner ? subtract(*outer, *inner) : std::nullopt;
}

}  // namespace model
