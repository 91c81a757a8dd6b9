#include "tri/sweep.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "tri/predicates.h"

namespace tri {

namespace {

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

}  // namespace

Fault sweep(std::span<const BorderEdge> border, std::span<const Point> lonePoints) {
    return Sweep(border, lonePoints).run();
}

}  // namespace tri
