#include "tri/verify.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "tri/predicates.h"

namespace tri {

namespace {

/// A border edge from one point to another, with the inside on its left.
using BorderEdge = std::pair<Point, Point>;

/// An edge from its lower to its higher end (by x, then y).
struct Segment {
    Point low;
    Point high;
    bool isForward;  ///< the border runs from low to high: the inside is above
};

/// Which of two segments that the sweep line meets at the same time is below? Equivalent if they lie on each other.
struct Below {
    bool operator()(const Segment* s, const Segment* t) const {
        if (t->low < s->low) {
            return isAbove(*t, *s) < 0;
        }
        return isAbove(*s, *t) > 0;
    }

    /// Sign of how far `later` starts above `early`; if they start together, how far it ends above.
    static std::int64_t isAbove(const Segment& early, const Segment& later) {
        const std::int64_t orientation = orient(early.low, early.high, later.low);
        return orientation != 0 ? orientation : orient(early.low, early.high, later.high);
    }
};

/// Do two segments share more than common ends?
bool isConflict(const Segment& s, const Segment& t) {
    const auto sign = [](std::int64_t value) { return (value > 0) - (value < 0); };
    const int a = sign(orient(s.low, s.high, t.low));
    const int b = sign(orient(s.low, s.high, t.high));
    const int c = sign(orient(t.low, t.high, s.low));
    const int d = sign(orient(t.low, t.high, s.high));
    if (a == 0 && b == 0) {
        return std::max(s.low, t.low) < std::min(s.high, t.high);  // on one line
    }
    const bool hasCommonEnd = s.low == t.low || s.high == t.high || s.low == t.high || s.high == t.low;
    return !hasCommonEnd && a * b <= 0 && c * d <= 0;
}

/// Sweeps a line over border edges and lone points. Overlap if two edges cross or touch anywhere but at common ends, or
/// if the inside is not on the left of every edge; MissingVertex if a lone point lies inside or on an edge.
class Sweep {
public:
    Sweep(std::span<const BorderEdge> border, std::span<const Point> lonePoints) {
        m_segments.reserve(border.size());
        for (const auto& [from, to] : border) {
            m_segments.push_back({std::min(from, to), std::max(from, to), from < to});
        }
        for (const Segment& segment : m_segments) {
            m_events.push_back({segment.high, Kind::End, &segment});
            m_events.push_back({segment.low, Kind::Start, &segment});
        }
        m_lone.assign(lonePoints.begin(), lonePoints.end());
        for (const Point& point : m_lone) {
            m_events.push_back({point, Kind::Lone, nullptr});
        }
        std::ranges::sort(m_events, {}, [](const Event& e) { return std::pair(e.at, e.kind); });
    }

    Fault run() {
        for (std::size_t i = 0; i < m_events.size();) {
            const Point at = m_events[i].at;
            std::vector<Active::iterator> started;
            for (; i < m_events.size() && m_events[i].at == at; ++i) {
                const Fault fault = handle(m_events[i], started);
                if (fault != Fault::None) {
                    return fault;
                }
            }
            // Sides alternate only once everything that starts here has started.
            for (const Active::iterator segment : started) {
                if (!alternates(segment)) {
                    return Fault::Overlap;
                }
            }
            if (started.empty() && m_touched && !gapAlternates(at)) {
                return Fault::Overlap;
            }
            m_touched = false;
        }
        return Fault::None;
    }

private:
    enum class Kind : std::uint8_t { End, Start, Lone };
    struct Event {
        Point at;
        Kind kind;
        const Segment* segment;
    };
    using Active = std::set<const Segment*, Below>;

    Fault handle(const Event& event, std::vector<Active::iterator>& started) {
        switch (event.kind) {
            case Kind::End: return end(event.segment);
            case Kind::Start: return start(event.segment, started);
            case Kind::Lone: break;
        }
        return isCovered(event.at) ? Fault::MissingVertex : Fault::None;
    }

    Fault end(const Segment* segment) {
        const auto found = m_active.find(segment);
        if (found == m_active.end() || *found != segment) {
            return Fault::Overlap;  // the order is broken: something crossed
        }
        m_touched = true;
        const auto above = m_active.erase(found);
        const bool isBetween = above != m_active.end() && above != m_active.begin();
        return isBetween && isConflict(**above, **std::prev(above)) ? Fault::Overlap : Fault::None;
    }

    Fault start(const Segment* segment, std::vector<Active::iterator>& started) {
        const auto [place, isNew] = m_active.insert(segment);
        if (!isNew) {
            return Fault::Overlap;
        }
        started.push_back(place);
        const auto above = std::next(place);
        const bool isHit = (above != m_active.end() && isConflict(*segment, **above)) ||
                           (place != m_active.begin() && isConflict(*segment, **std::prev(place)));
        return isHit ? Fault::Overlap : Fault::None;
    }

    /// From below to above: outside, forward edge, inside, backward edge, outside, ...
    [[nodiscard]] bool alternates(Active::iterator place) const {
        const bool isBelowForward = place != m_active.begin() && (*std::prev(place))->isForward;
        const auto above = std::next(place);
        const bool isAboveForward = above == m_active.end() || (*above)->isForward;
        return (*place)->isForward != isBelowForward && (*place)->isForward != isAboveForward;
    }

    /// The lowest active segment that has the point below it or on it.
    [[nodiscard]] Active::const_iterator firstNotBelow(Point at) const {
        const Segment probe{at, at, true};
        return std::ranges::partition_point(m_active,
                                            [&](const Segment* s) { return orient(s->low, s->high, probe.low) > 0; });
    }

    [[nodiscard]] bool gapAlternates(Point at) const {
        const auto above = firstNotBelow(at);
        const bool isBelowForward = above != m_active.begin() && (*std::prev(above))->isForward;
        return above == m_active.end() ? !isBelowForward : (*above)->isForward != isBelowForward;
    }

    [[nodiscard]] bool isCovered(Point at) const {
        const auto above = firstNotBelow(at);
        const bool isOnEdge = above != m_active.end() && orient((*above)->low, (*above)->high, at) == 0;
        return isOnEdge || (above != m_active.end() && !(*above)->isForward);
    }

    std::vector<Segment> m_segments;
    std::vector<Point> m_lone;
    std::vector<Event> m_events;
    Active m_active;
    bool m_touched = false;
};

/// One run along an edge between two positions (by their lowest index): +1 of a triangle, -1 of a contour, from the
/// lower to the higher index; the other way around the signs swap.
struct Run {
    std::uint32_t low;
    std::uint32_t high;
    std::int32_t sign;
    std::uint32_t apex;  ///< third corner of the triangle; kNoApex for a contour
};
constexpr std::uint32_t kNoApex = 0xFFFFFFFF;

Run runFrom(std::uint32_t from, std::uint32_t to, std::int32_t sign, std::uint32_t apex) {
    return from < to ? Run{from, to, sign, apex} : Run{to, from, -sign, apex};
}

class Verifier {
public:
    Verifier(const Polygon& polygon, std::span<const std::uint32_t> triangles)
        : m_points(polygon.points), m_polygon(polygon), m_triangles(triangles) {}

    Fault run() {
        findLowest();
        for (const auto check : {&Verifier::checkTriangles, &Verifier::checkArea, &Verifier::checkEdges,
                                 &Verifier::checkLeftOver, &Verifier::checkSweep}) {
            const Fault fault = (this->*check)();
            if (fault != Fault::None) {
                return fault;
            }
        }
        return Fault::None;
    }

private:
    void findLowest() {
        std::vector<std::uint32_t> order(m_points.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(m_points[i], i); });
        m_lowest.resize(m_points.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool repeats = i > 0 && m_points[order[i]] == m_points[order[i - 1]];
            m_lowest[order[i]] = repeats ? m_lowest[order[i - 1]] : order[i];
        }
    }

    Fault checkTriangles() {
        m_isCorner.assign(m_points.size(), false);
        if (m_triangles.size() % 3 != 0) {
            return Fault::BadIndex;
        }
        for (const std::uint32_t i : m_triangles) {
            if (i >= m_points.size() || m_lowest[i] != i) {
                return Fault::BadIndex;
            }
            m_isCorner[i] = true;
        }
        for (std::size_t i = 0; i < m_triangles.size(); i += 3) {
            const std::int64_t area =
                orient(m_points[m_triangles[i]], m_points[m_triangles[i + 1]], m_points[m_triangles[i + 2]]);
            if (area <= 0) {
                return Fault::NotCounterClockwise;
            }
            m_area += area;
        }
        return Fault::None;
    }

    /// Calls `visit(i, next)` for every contour edge.
    template <class Visit>
    void forEachEdge(const Visit& visit) const {
        for (std::size_t loop = 0; loop + 1 < m_polygon.loopStart.size(); ++loop) {
            const std::uint32_t first = m_polygon.loopStart[loop];
            const std::uint32_t end = m_polygon.loopStart[loop + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                visit(i, i + 1 < end ? i + 1 : first);
            }
        }
    }

    Fault checkArea() {
        Int128 area = 0;
        forEachEdge([&](std::uint32_t i, std::uint32_t next) {
            const Point a = m_points[i];
            const Point b = m_points[next];
            area += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
        });
        return area == m_area ? Fault::None : Fault::WrongArea;
    }

    [[nodiscard]] std::vector<Run> collectRuns() const {
        std::vector<Run> runs;
        runs.reserve(m_triangles.size() + m_points.size());
        for (std::size_t i = 0; i < m_triangles.size(); i += 3) {
            const std::uint32_t* v = &m_triangles[i];
            runs.push_back(runFrom(v[0], v[1], 1, v[2]));
            runs.push_back(runFrom(v[1], v[2], 1, v[0]));
            runs.push_back(runFrom(v[2], v[0], 1, v[1]));
        }
        forEachEdge([&](std::uint32_t i, std::uint32_t next) {
            if (m_lowest[i] != m_lowest[next]) {
                runs.push_back(runFrom(m_lowest[i], m_lowest[next], -1, kNoApex));
            }
        });
        std::ranges::sort(runs, {}, [](const Run& r) { return std::tuple(r.low, r.high, r.apex, r.sign); });
        return runs;
    }

    /// Every edge has at most one triangle per side. With two, it is Delaunay; with one, it is border. What triangles
    /// and contours do not have in common along an edge is left over for checkLeftOver.
    Fault checkEdges() {
        const std::vector<Run> runs = collectRuns();
        for (std::size_t i = 0, end = 0; i < runs.size(); i = end) {
            std::int32_t sum = 0;
            std::array<const Run*, 2> sides{};
            for (end = i; end < runs.size() && runs[end].low == runs[i].low && runs[end].high == runs[i].high; ++end) {
                sum += runs[end].sign;
                if (runs[end].apex != kNoApex) {
                    const Run*& side = sides[runs[end].sign > 0 ? 0 : 1];
                    if (side != nullptr) {
                        return Fault::Overlap;
                    }
                    side = &runs[end];
                }
            }
            if (sides[0] != nullptr && sides[1] != nullptr) {
                if (isFlipNeeded(*sides[0], *sides[1])) {
                    return Fault::NotDelaunay;
                }
            } else if (sides[0] != nullptr) {
                m_border.emplace_back(m_points[runs[i].low], m_points[runs[i].high]);
            } else if (sides[1] != nullptr) {
                m_border.emplace_back(m_points[runs[i].high], m_points[runs[i].low]);
            }
            if (sum != 0) {
                m_leftOver.push_back({m_points[runs[i].low], m_points[runs[i].high], sum});
            }
        }
        return Fault::None;
    }

    [[nodiscard]] bool isFlipNeeded(const Run& left, const Run& right) const {
        const auto site = [&](std::uint32_t i) { return Site{m_points[i], i}; };
        return isInPerturbedCircle(site(left.low), site(left.high), site(left.apex), site(right.apex));
    }

    struct LeftOver {
        Point from;
        Point to;
        std::int32_t sum;
    };
    /// A line through the grid: direction without common factor, pointing right (or up), and distance from the origin.
    struct Line {
        std::int64_t dx, dy, offset;
        auto operator<=>(const Line&) const = default;
    };

    static Line lineOf(Point a, Point b) {
        std::int64_t dx = std::int64_t{b.x} - a.x;
        std::int64_t dy = std::int64_t{b.y} - a.y;
        const std::int64_t factor = a < b ? std::gcd(dx, dy) : -std::gcd(dx, dy);
        dx /= factor;
        dy /= factor;
        return {dx, dy, dx * a.y - dy * a.x};
    }

    /// Contours may run through vertices, so left-over edges are compared piece by piece: on every line, what begins
    /// and what ends has to add up to nothing all the way along.
    Fault checkLeftOver() {
        std::vector<std::tuple<Line, Point, std::int32_t>> changes;
        for (const LeftOver& edge : m_leftOver) {
            const Line line = lineOf(edge.from, edge.to);
            changes.emplace_back(line, edge.from, edge.sum);
            changes.emplace_back(line, edge.to, -edge.sum);
        }
        std::ranges::sort(changes);
        for (std::size_t i = 0; i < changes.size();) {
            const auto [line, at, unused] = changes[i];
            std::int32_t sum = 0;
            for (; i < changes.size() && std::get<Line>(changes[i]) == line && std::get<Point>(changes[i]) == at; ++i) {
                sum += std::get<std::int32_t>(changes[i]);
            }
            if (sum != 0) {
                return Fault::WrongBorder;
            }
        }
        return Fault::None;
    }

    Fault checkSweep() {
        std::vector<Point> lone;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            if (m_lowest[i] == i && !m_isCorner[i]) {
                lone.push_back(m_points[i]);
            }
        }
        return Sweep(m_border, lone).run();
    }

    std::span<const Point> m_points;
    const Polygon& m_polygon;
    std::span<const std::uint32_t> m_triangles;
    std::vector<std::uint32_t> m_lowest;
    std::vector<bool> m_isCorner;
    Int128 m_area = 0;
    std::vector<BorderEdge> m_border;
    std::vector<LeftOver> m_leftOver;
};

}  // namespace

std::string_view nameOf(Fault fault) {
    constexpr std::array<std::string_view, 8> kNames = {"none",           "bad index",    "not counter-clockwise",
                                                        "wrong area",     "wrong border", "overlap",
                                                        "missing vertex", "not Delaunay"};
    return kNames[static_cast<std::size_t>(fault)];
}

Fault verify(const Polygon& polygon, std::span<const std::uint32_t> triangles) {
    return Verifier(polygon, triangles).run();
}

}  // namespace tri
