#include "model/geometry/loops/fit_arcs.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// Corners of an arc are rounded to the grid of the program that made them.
constexpr double kOnCircle = 50.0;
constexpr std::size_t kFewestChords = 3;
/// An arc that is nearly a circle has no good direction at its ends.
constexpr double kWidestSweep = 5.0;

struct Circle {
    PointD centre;
    double radius = 0.0;
};

std::optional<Circle> circleThrough(PointD a, PointD b, PointD c) {
    const PointD u = minus(b, a);
    const PointD v = minus(c, a);
    const double twice = 2 * cross(u, v);
    if (std::abs(twice) < 1e-9 * dot(u, u)) {
        return std::nullopt;
    }
    const PointD centre{a.x + (v.y * dot(u, u) - u.y * dot(v, v)) / twice,
                        a.y + (u.x * dot(v, v) - v.x * dot(u, u)) / twice};
    return Circle{centre, distance(centre, a)};
}

/// A run of lines of a loop.
class Run {
public:
    Run(std::span<const Edge> loop, std::size_t first, double tolerance)
        : m_loop(loop), m_first(first), m_tolerance(tolerance) {}

    /// The circle on which the first `count` chords lie.
    [[nodiscard]] std::optional<Circle> circleOf(std::size_t count) const {
        const std::optional<Circle> circle = circleThrough(corner(0), corner(count / 2), corner(count));
        double sweep = 0.0;
        for (std::size_t i = 0; circle && i < count; ++i) {
            const std::optional<double> step = sweepOf(*circle, i);
            if (!step || (i > 0 && *step * sweep <= 0)) {
                return std::nullopt;
            }
            sweep += *step;
        }
        return std::abs(sweep) <= kWidestSweep ? circle : std::nullopt;
    }

    /// The circle that a closed loop of chords is.
    [[nodiscard]] std::optional<Circle> wholeCircle() const {
        const std::size_t count = m_loop.size();
        const std::optional<Circle> circle = circleThrough(corner(0), corner(count / 3), corner(2 * count / 3));
        double sweep = 0.0;
        for (std::size_t i = 0; circle && i < count; ++i) {
            const std::optional<double> step = sweepOf(*circle, i);
            if (!step || (i > 0 && *step * sweep <= 0)) {
                return std::nullopt;
            }
            sweep += *step;
        }
        return std::abs(std::abs(sweep) - 2 * std::numbers::pi) < 0.01 ? circle : std::nullopt;
    }

    /// How many chords from the first one on are one arc; 0 if too few.
    [[nodiscard]] std::size_t longest() const {
        std::size_t count = kFewestChords;
        while (m_first + count <= m_loop.size() && !m_loop[m_first + count - 1].isArc() && circleOf(count)) {
            ++count;
        }
        return count > kFewestChords ? count - 1 : 0;
    }

private:
    [[nodiscard]] PointD corner(std::size_t i) const {
        const std::size_t at = m_first + i;
        return at < m_loop.size() ? m_loop[at].a : m_loop.back().b;
    }

    /// By how much the circle turns along a chord, if the chord keeps close to it.
    [[nodiscard]] std::optional<double> sweepOf(const Circle& circle, std::size_t i) const {
        const Edge& chord = m_loop[m_first + i];
        const PointD a = minus(chord.a, circle.centre);
        const PointD b = minus(chord.b, circle.centre);
        const bool isOn =
            std::abs(length(a) - circle.radius) <= kOnCircle && std::abs(length(b) - circle.radius) <= kOnCircle;
        const double sweep = std::atan2(cross(a, b), dot(a, b));
        const double away = circle.radius * (1 - std::cos(sweep / 2));
        return isOn && !chord.isArc() && away + kOnCircle <= m_tolerance ? std::optional(sweep) : std::nullopt;
    }

    std::span<const Edge> m_loop;
    std::size_t m_first;
    double m_tolerance;
};

void addFitted(EdgeLoops& fitted, std::span<const Edge> loop, double tolerance) {
    if (loop.size() > 2 * kFewestChords) {
        if (const auto circle = Run(loop, 0, tolerance).wholeCircle()) {
            return fitted.addCircle(circle->centre, circle->radius);
        }
    }
    for (std::size_t i = 0; i < loop.size();) {
        const Run run(loop, i, tolerance);
        const std::size_t count = loop[i].isArc() ? 0 : run.longest();
        if (count == 0) {
            fitted.edges.push_back(loop[i++]);
            continue;
        }
        const Circle circle = *run.circleOf(count);
        const PointD from = loop[i].a;
        const PointD to = loop[i + count - 1].b;
        const bool isClockwise = cross(minus(loop[i].a, circle.centre), minus(loop[i].b, circle.centre)) < 0;
        fitted.addArc(from, to, circle.centre, isClockwise);
        i += count;
    }
    fitted.endLoop();
}

}  // namespace

EdgeLoops withFittedArcs(const EdgeLoops& region, double tolerance) {
    if (!region.curves.empty()) {
        return region;
    }
    EdgeLoops fitted;
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        addFitted(fitted, region.loop(i), tolerance);
    }
    const bool isLike = fitted.loopCount() == region.loopCount() && fitted.edges.size() < region.edges.size();
    return isLike && !findFault(fitted) ? fitted : region;
}

}  // namespace model
