#include "model/geometry/loops/boundary_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/vectors.h"

namespace model {

namespace {

using Circle = EdgeArrangement::Circle;
constexpr double kStraightNm = 0.25;   ///< corners this near to a straight line are dropped
constexpr double kOneCircleNm = 0.05;  ///< circles this similar are one
constexpr double kPinchNm = 1.2;
constexpr std::size_t kMostDropped = 64;
constexpr double kPi = std::numbers::pi;

/// One fragment on its way along the loop.
struct Step {
    PointD from;
    bool isFixed = false;  ///< `from` stays a corner
    std::int32_t circle = EdgeArrangement::kLine;
    bool isClockwise = false;
};

/// The direction in which an edge leaves its start.
double directionOf(const Edge& edge) {
    if (!edge.isArc()) {
        return std::atan2(edge.b.y - edge.a.y, edge.b.x - edge.a.x);
    }
    const PointD out = minus(edge.a, edge.centre);
    return edge.isClockwise ? std::atan2(-out.x, out.y) : std::atan2(out.x, -out.y);
}

class LoopJoiner {
public:
    LoopJoiner(const EdgeArrangement& arrangement, std::span<const Side> loop, std::span<const std::uint8_t> isPinched)
        : m_arrangement(arrangement) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            addStep(loop[(i + loop.size() - 1) % loop.size()], loop[i], isPinched);
        }
    }

    std::vector<Edge> join() {
        std::size_t start = 0;
        while (start < m_steps.size() && goesOn(start)) {
            ++start;
        }
        if (start == m_steps.size() && m_steps.front().circle != EdgeArrangement::kLine) {
            addCircle();
            return std::move(m_edges);
        }
        std::rotate(m_steps.begin(), m_steps.begin() + static_cast<std::ptrdiff_t>(start % m_steps.size()),
                    m_steps.end());
        for (std::size_t first = 0; first < m_steps.size();) {
            const std::size_t end = endOfRun(first);
            m_steps[first].circle == EdgeArrangement::kLine ? addLine(first, end) : addArc(first, end);
            first = end;
        }
        return std::move(m_edges);
    }

private:
    [[nodiscard]] PointD cornerAt(std::size_t i) const { return m_steps[i % m_steps.size()].from; }
    [[nodiscard]] const Circle& circleOf(const Step& step) const { return m_arrangement.circle(step.circle); }
    [[nodiscard]] Edge edgeOf(Side side) const {
        const Edge edge = m_arrangement.edgeOf(m_arrangement.fragments()[side / 2]);
        return side % 2 == 0 ? edge : reversed(edge);
    }

    void addStep(Side before, Side side, std::span<const std::uint8_t> isPinched) {
        const EdgeArrangement::Fragment& fragment = m_arrangement.fragments()[side / 2];
        const bool isForward = side % 2 == 0;
        const std::uint32_t vertex = isForward ? fragment.a : fragment.b;
        Step step{m_arrangement.vertices()[vertex], isPinched[vertex] != 0, fragment.circle,
                  fragment.isClockwise == isForward};
        if (step.isFixed) {
            const double out = directionOf(edgeOf(side));
            const double back = directionOf(reversed(edgeOf(before)));
            const double half = (back > out ? back - out : back - out + 2 * kPi) / 2;
            const double away = kPinchNm / std::max(std::sin(half), 0.4);
            step.from = {step.from.x + away * std::cos(out + half), step.from.y + away * std::sin(out + half)};
        }
        m_steps.push_back(step);
    }

    [[nodiscard]] bool areOneCircle(const Step& a, const Step& b) const {
        return a.isClockwise == b.isClockwise &&
               (a.circle == b.circle || (std::abs(circleOf(a).radius - circleOf(b).radius) < kOneCircleNm &&
                                         length(minus(circleOf(a).centre, circleOf(b).centre)) < kOneCircleNm));
    }

    [[nodiscard]] bool isStraight(PointD a, PointD corner, PointD b) const {
        const PointD chord = minus(b, a);
        const PointD v = minus(corner, a);
        return std::abs(cross(chord, v)) < kStraightNm * length(chord) && dot(v, chord) > 0 &&
               dot(minus(b, corner), chord) > 0;
    }

    /// Does step `i` go on along the edge of the step before it?
    [[nodiscard]] bool goesOn(std::size_t i) const {
        const Step& step = m_steps[i];
        const std::size_t previous = (i + m_steps.size() - 1) % m_steps.size();
        const Step& before = m_steps[previous];
        const bool isLine = step.circle == EdgeArrangement::kLine;
        if (step.isFixed || isLine != (before.circle == EdgeArrangement::kLine)) {
            return false;
        }
        return isLine ? isStraight(before.from, step.from, cornerAt(i + 1)) : areOneCircle(before, step);
    }

    [[nodiscard]] std::size_t endOfRun(std::size_t first) const {
        std::size_t end = first + 1;
        while (end < m_steps.size() && goesOn(end) && staysStraight(first, end + 1)) {
            ++end;
        }
        return end;
    }

    /// All corners between two of them lie on their line.
    [[nodiscard]] bool staysStraight(std::size_t first, std::size_t end) const {
        if (m_steps[first].circle != EdgeArrangement::kLine) {
            return true;
        }
        if (end - first > kMostDropped) {
            return false;
        }
        for (std::size_t i = first + 1; i < end; ++i) {
            if (!isStraight(m_steps[first].from, m_steps[i].from, cornerAt(end))) {
                return false;
            }
        }
        return true;
    }

    void addCircle() {
        const Circle& circle = circleOf(m_steps.front());
        Edge edge;
        edge.a = edge.b = {circle.centre.x + circle.radius, circle.centre.y};
        edge.centre = circle.centre;
        edge.radius = circle.radius;
        edge.isClockwise = m_steps.front().isClockwise;
        m_edges.push_back(edge);
    }

    void addLine(std::size_t first, std::size_t end) {
        Edge edge;
        edge.a = cornerAt(first);
        edge.b = cornerAt(end);
        m_edges.push_back(edge);
    }

    void addArc(std::size_t first, std::size_t end) {
        const Circle& circle = circleOf(m_steps[first]);
        const bool isClockwise = m_steps[first].isClockwise;
        const PointD a = cornerAt(first);
        const PointD b = cornerAt(end);
        double sweep = 0.0;
        for (std::size_t i = first; i < end; ++i) {
            const double half = length(minus(cornerAt(i + 1), cornerAt(i))) / (2 * circle.radius);
            sweep += 2 * std::asin(std::min(half, 1.0));
        }
        const double chord = length(minus(b, a));
        const double mismatch = std::abs(distance(a, circle.centre) - distance(b, circle.centre));
        // How far the centre of one arc would have to move, and whether it would be taken for its chord.
        const bool isFar = mismatch * circle.radius > chord || chord * chord < circle.radius + 64.0;
        if (sweep <= 0.75 * kPi || !isFar) {
            m_edges.push_back(arcThrough(a, b, circle, isClockwise));
            return;
        }
        const double angle =
            std::atan2(a.y - circle.centre.y, a.x - circle.centre.x) + (isClockwise ? -sweep : sweep) / 2;
        const PointD middle{circle.centre.x + circle.radius * std::cos(angle),
                            circle.centre.y + circle.radius * std::sin(angle)};
        m_edges.push_back(arcThrough(a, middle, circle, isClockwise));
        m_edges.push_back(arcThrough(middle, b, circle, isClockwise));
    }

    const EdgeArrangement& m_arrangement;
    std::vector<Step> m_steps;
    std::vector<Edge> m_edges;
};

}  // namespace

std::vector<Edge> edgesOf(const EdgeArrangement& arrangement, std::span<const Side> loop,
                          std::span<const std::uint8_t> isPinched) {
    return LoopJoiner(arrangement, loop, isPinched).join();
}

}  // namespace model
