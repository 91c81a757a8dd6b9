#include "model/geometry/clear_loops.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/box_pairs.h"

namespace model {

namespace {

/// Rounding moves an x that is not on the grid so far at most, nm, and double may err by the rest.
constexpr double kRounding = 0.51;
/// Sides nearer to each other than rounding can bridge are followed over so many levels.
constexpr int kMostFollowed = 16;

/// A straight side of a loop, its lower end first.
struct Side {
    Point low;
    Point high;

    Side(Point a, Point b) : low(a.y < b.y ? a : b), high(a.y < b.y ? b : a) {}

    [[nodiscard]] bool isLevel() const { return low.y == high.y; }
    [[nodiscard]] bool touches(Nm level) const { return low.y <= level && level <= high.y; }
};

/// Where a side meets a level line: all of it if it is level itself.
struct Meeting {
    double left = 0.0;
    double right = 0.0;
    double rounding = 0.0;  ///< how far that may move
};

Meeting meetingOf(const Side& side, Nm level) {
    if (side.isLevel()) {
        const auto [left, right] = std::minmax(side.low.x, side.high.x);
        return {static_cast<double>(left), static_cast<double>(right), 0.0};
    }
    const std::int64_t width = std::int64_t{side.high.x} - side.low.x;
    const std::int64_t height = std::int64_t{side.high.y} - side.low.y;
    const std::int64_t product = width * (std::int64_t{level} - side.low.y);
    const double x = side.low.x + static_cast<double>(product) / static_cast<double>(height);
    return {x, x, product % height == 0 ? 0.0 : kRounding};
}

/// How far `b` is to the right of `a` (below 0: to the left), 0 where they may be the same after rounding.
double gapBetween(const Side& a, const Side& b, Nm level) {
    const Meeting of = meetingOf(a, level);
    const Meeting other = meetingOf(b, level);
    const double rounding = of.rounding + other.rounding;
    if (other.left - of.right > rounding) {
        return other.left - of.right;
    }
    return of.left - other.right > rounding ? other.right - of.left : 0.0;
}

class LoopSides {
public:
    explicit LoopSides(const LoopSet& loops) {
        for (std::size_t i = 0; i + 1 < loops.loopStart.size(); ++i) {
            addLoop(std::span(loops.points).subspan(loops.loopStart[i], loops.loopStart[i + 1] - loops.loopStart[i]));
        }
        std::ranges::transform(loops.points, std::back_inserter(m_levels), &Point::y);
        std::ranges::sort(m_levels);
        m_levels.erase(std::unique(m_levels.begin(), m_levels.end()), m_levels.end());
    }

    [[nodiscard]] bool areClear() const { return !m_hasSpike && areNeighboursApart() && areOthersApart(); }

private:
    void addLoop(std::span<const Point> loop) {
        const auto first = static_cast<std::uint32_t>(m_sides.size());
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point corner = loop[i];
            const Point before = loop[i == 0 ? loop.size() - 1 : i - 1];
            const Point after = loop[i + 1 < loop.size() ? i + 1 : 0];
            const bool isLevelSpike =
                before.y == corner.y && after.y == corner.y && (before.x > corner.x) == (after.x > corner.x);
            m_hasSpike = m_hasSpike || isLevelSpike || before == corner || before == after;
            m_corners.push_back(corner);
            m_sides.emplace_back(corner, after);
            m_next.push_back(i + 1 < loop.size() ? static_cast<std::uint32_t>(first + i + 1) : first);
        }
    }

    [[nodiscard]] bool areNeighboursApart() const {
        for (std::size_t i = 0; i < m_sides.size(); ++i) {
            if (!areNeighboursApart(m_sides[i], m_sides[m_next[i]], m_corners[m_next[i]].y)) {
                return false;
            }
        }
        return true;
    }

    /// Where both lead up or both down from their corner; from there on they go apart.
    [[nodiscard]] bool areNeighboursApart(const Side& a, const Side& b, Nm corner) const {
        if (a.isLevel() || b.isLevel()) {
            return true;
        }
        if (a.low.y == corner && b.low.y == corner) {
            return stayApart(a, b, levelAt(corner) + 1, 1);
        }
        const bool leadDown = a.high.y == corner && b.high.y == corner;
        return !leadDown || stayApart(a, b, levelAt(corner) - 1, -1);
    }

    [[nodiscard]] bool areOthersApart() const {
        std::vector<Box> boxes(m_sides.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            boxes[i].include(m_sides[i].low);
            boxes[i].include(m_sides[i].high);
            boxes[i] = boxes[i].grownBy(1);  // 2 nm between two: more than rounding bridges
        }
        bool areApart = true;
        visitPairs(
            boxes, [](std::uint32_t) { return true; },
            [&](std::uint32_t i, std::uint32_t j) {
                const bool areNeighbours = m_next[i] == j || m_next[j] == i;
                areApart = areApart && (areNeighbours || areOthersApart(m_sides[i], m_sides[j]));
            });
        return areApart;
    }

    /// Their gap changes evenly between the lowest and the highest level that both touch.
    [[nodiscard]] bool areOthersApart(const Side& a, const Side& b) const {
        const Nm lowest = std::max(a.low.y, b.low.y);
        const Nm highest = std::min(a.high.y, b.high.y);
        if (lowest > highest) {
            return true;
        }
        const bool changePlaces = gapBetween(a, b, lowest) * gapBetween(a, b, highest) <= 0.0;
        return !changePlaces && stayApart(a, b, levelAt(lowest), 1) && stayApart(a, b, levelAt(highest), -1);
    }

    /// From this level on, as far as both touch the levels or until no rounding bridges their gap.
    [[nodiscard]] bool stayApart(const Side& a, const Side& b, std::ptrdiff_t level, int step) const {
        const auto end = static_cast<std::ptrdiff_t>(m_levels.size());
        for (int i = 0; i < kMostFollowed; ++i, level += step) {
            if (level < 0 || level >= end) {
                return true;
            }
            const Nm at = m_levels[static_cast<std::size_t>(level)];
            if (!a.touches(at) || !b.touches(at)) {
                return true;
            }
            const double gap = std::abs(gapBetween(a, b, at));
            if (gap == 0.0 || gap > 2 * kRounding) {
                return gap != 0.0;
            }
        }
        return false;
    }

    [[nodiscard]] std::ptrdiff_t levelAt(Nm y) const {
        return std::ranges::lower_bound(m_levels, y) - m_levels.begin();
    }

    std::vector<Point> m_corners;
    std::vector<Side> m_sides;          ///< from the corner of the same row
    std::vector<std::uint32_t> m_next;  ///< the side behind it
    std::vector<Nm> m_levels;           ///< of all corners, rising
    bool m_hasSpike = false;
};

}  // namespace

bool areClear(const LoopSet& loops) {
    return LoopSides(loops).areClear();
}

}  // namespace model
