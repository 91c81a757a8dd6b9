#include "model/solids/shells/trail_offset.h"

#include <cmath>
#include <utility>
#include <vector>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_meetings.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kWeldNm = 1.5;  ///< ends this near to each other are one

PointD directionAtStart(const Edge& edge) {
    const PointD v = edge.isArc() ? minus(edge.a, edge.centre) : minus(edge.b, edge.a);
    return !edge.isArc() ? v : edge.isClockwise ? PointD{v.y, -v.x} : PointD{-v.y, v.x};
}

PointD directionAtEnd(const Edge& edge) {
    const PointD v = edge.isArc() ? minus(edge.b, edge.centre) : minus(edge.b, edge.a);
    return !edge.isArc() ? v : edge.isClockwise ? PointD{v.y, -v.x} : PointD{-v.y, v.x};
}

Edge circleAround(PointD centre, double radius) {
    Edge circle;
    circle.a = circle.b = {centre.x + radius, centre.y};
    circle.centre = centre;
    circle.radius = radius;
    return circle;
}

/// The right side of a row of tracks, from its first to its last one.
class RightSide {
public:
    explicit RightSide(std::span<const Edge> tracks) : m_tracks(tracks) {}

    /// False where a side cannot be told from its neighbours alone.
    bool build() {
        m_sides.reserve(2 * m_tracks.size());
        for (std::size_t i = 0; i < m_tracks.size(); ++i) {
            if (!offset(m_tracks[i]) || (i > 0 && !join(i))) {
                m_brokenAt = i;
                return false;
            }
            m_sides.push_back(m_side);
            m_whole = m_side;
        }
        return true;
    }
    /// The same of a closed row of tracks: all around.
    bool buildAround() {
        std::vector<Edge> around(m_tracks.begin(), m_tracks.end());
        around.push_back(m_tracks.front());
        const std::span<const Edge> once = std::exchange(m_tracks, around);
        const bool isBuilt = build();
        m_tracks = once;
        if (isBuilt) {
            m_sides.front().a = m_sides.back().a;
            m_sides.pop_back();
        }
        return isBuilt && runsForward(m_sides.front(), m_whole);
    }
    [[nodiscard]] std::span<const Edge> sides() const { return m_sides; }
    [[nodiscard]] std::size_t brokenAt() const { return m_brokenAt; }

private:
    bool offset(const Edge& track) {
        m_side = track;
        if (track.isArc()) {
            m_side.radius = track.isClockwise ? track.radius - track.pen : track.radius + track.pen;
            if (m_side.radius <= kWeldNm) {
                return false;
            }
            const double scale = m_side.radius / track.radius;
            m_side.a = {track.centre.x + (track.a.x - track.centre.x) * scale,
                        track.centre.y + (track.a.y - track.centre.y) * scale};
            m_side.b = {track.centre.x + (track.b.x - track.centre.x) * scale,
                        track.centre.y + (track.b.y - track.centre.y) * scale};
            return true;
        }
        const PointD v = minus(track.b, track.a);
        const double scale = track.pen / length(v);
        const PointD right{v.y * scale, -v.x * scale};
        m_side.a = {track.a.x + right.x, track.a.y + right.y};
        m_side.b = {track.b.x + right.x, track.b.y + right.y};
        return true;
    }

    /// Between the last side and the new one, m_side.
    bool join(std::size_t i) {
        Edge& before = m_sides.back();
        const double pen = m_tracks[i - 1].pen;
        const double next = m_tracks[i].pen;
        const PointD node = m_tracks[i].a;
        PointD from = before.b;
        PointD to = m_side.a;
        if (pen > next) {
            const std::optional<PointD> on = onlyMeeting(m_side, circleAround(node, pen));
            if (!on) {
                return false;
            }
            to = *on;
        } else if (pen < next) {
            const std::optional<PointD> on = onlyMeeting(before, circleAround(node, next));
            if (!on) {
                return false;
            }
            from = *on;
        }
        if (length(minus(from, to)) <= kWeldNm) {
            return pen >= next ? weld(from, to, before.isArc()) : weld(from, to, !m_side.isArc());
        }
        if (turnsLeft(from, to, node, i, pen == next)) {
            return endAt(before, from) && startAt(to) && addJoint(from, to, node, std::max(pen, next));
        }
        const std::optional<PointD> crossing = onlyMeeting(before, m_side);
        return crossing && endAt(before, *crossing) && startAt(*crossing);
    }

    [[nodiscard]] bool turnsLeft(PointD from, PointD to, PointD node, std::size_t i, bool isOneWidth) const {
        if (isOneWidth) {
            return cross(directionAtEnd(m_tracks[i - 1]), directionAtStart(m_tracks[i])) > 0;
        }
        return cross(minus(from, node), minus(to, node)) > 0;
    }

    /// One point for the end of the last side and the start of the new one.
    bool weld(PointD from, PointD to, bool isAtFrom) {
        const PointD p = isAtFrom ? from : to;
        return endAt(m_sides.back(), p) && startAt(p);
    }

    bool endAt(Edge& side, PointD p) {
        side.b = p;
        return runsForward(side, m_whole);
    }
    bool startAt(PointD p) {
        m_whole = m_side;
        m_side.a = p;
        return runsForward(m_side, m_whole);
    }

    /// Is what was cut off less than all of it?
    static bool runsForward(const Edge& side, const Edge& whole) {
        const PointD v = minus(side.b, side.a);
        if (dot(v, v) <= 4 * kWeldNm * kWeldNm) {
            return false;
        }
        if (!side.isArc()) {
            return dot(v, minus(whole.b, whole.a)) > 0;
        }
        return lengthOf(side) < lengthOf(whole) + 2 * kWeldNm;
    }

    bool addJoint(PointD from, PointD to, PointD node, double radius) {
        Edge joint = circleAround(node, radius);
        joint.a = from;
        joint.b = to;
        m_sides.push_back(joint);
        return true;
    }

    static std::optional<PointD> onlyMeeting(const Edge& a, const Edge& b) {
        const Meetings meetings = meetingsOf(a, b);
        return meetings.count == 1 ? std::optional(meetings.at[0]) : std::nullopt;
    }

    std::span<const Edge> m_tracks;
    std::vector<Edge> m_sides;
    Edge m_side;
    std::size_t m_brokenAt = 0;
    Edge m_whole;  ///< the last side before its end was cut
};

void add(EdgeLoops& loops, const Edge& edge) {
    if (edge.isArc()) {
        loops.addArc(edge.a, edge.b, edge.centre, edge.isClockwise);
    } else {
        loops.addLine(edge.a, edge.b);
    }
}

double areaWithin(std::span<const Edge> sides) {
    double area = 0.0;
    for (const Edge& side : sides) {
        area += areaUnder(side, sides.front().a);
    }
    return area;
}

bool addLoop(EdgeLoops& loops, std::span<const Edge> sides) {
    for (const Edge& side : sides) {
        add(loops, side);
    }
    return loops.endLoop();
}

/// Half a circle from the end of one side to the start of the other one.
void addCap(EdgeLoops& loops, const Edge& from, const Edge& to, const Edge& track) {
    loops.addArc(from.b, to.a, track.b, false);
}

std::vector<Edge> turned(std::span<const Edge> tracks) {
    std::vector<Edge> back(tracks.rbegin(), tracks.rend());
    for (Edge& track : back) {
        track = reversed(track);
    }
    return back;
}

}  // namespace

std::optional<EdgeLoops> offsetRing(std::span<const Edge> tracks) {
    const std::vector<Edge> back = turned(tracks);
    RightSide right(tracks);
    RightSide left(back);
    if (tracks.size() < 2 || !right.buildAround() || !left.buildAround()) {
        return std::nullopt;
    }
    // Of the two sides one is the outline, counter-clockwise, and the other one the hole, clockwise.
    const bool isRightOutside = areaWithin(right.sides()) > 0.0;
    if (isRightOutside == (areaWithin(left.sides()) > 0.0)) {
        return std::nullopt;
    }
    EdgeLoops loops;
    const bool isWhole = addLoop(loops, isRightOutside ? right.sides() : left.sides()) &&
                         addLoop(loops, isRightOutside ? left.sides() : right.sides());
    return isWhole && !findFault(loops) ? std::optional(std::move(loops)) : std::nullopt;
}

Offset offsetOutline(std::span<const Edge> tracks) {
    RightSide right(tracks);
    if (tracks.empty() || !right.build()) {
        return {std::nullopt, right.brokenAt()};
    }
    const std::vector<Edge> back = turned(tracks);
    RightSide left(back);
    if (!left.build()) {
        return {std::nullopt, tracks.size() - left.brokenAt()};
    }
    EdgeLoops loops;
    loops.edges.reserve(right.sides().size() + left.sides().size() + 2);
    for (const Edge& side : right.sides()) {
        add(loops, side);
    }
    addCap(loops, right.sides().back(), left.sides().front(), tracks.back());
    for (const Edge& side : left.sides()) {
        add(loops, side);
    }
    addCap(loops, left.sides().back(), right.sides().front(), back.back());
    const bool isWhole = loops.endLoop() && loops.edges.front().a == right.sides().front().a;  // not turned round
    if (!isWhole || findFault(loops)) {
        return {std::nullopt, tracks.size() / 2};
    }
    return {std::move(loops), 0};
}

}  // namespace model
