#include "model/geometry/nurbs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/assert.h"
#include "model/geometry/scratch.h"

namespace model {

namespace {

/// Room for the points of one step of de Boor's scheme.
using Points = Scratch<Homogeneous, kMostFixedDegree + 1>;

/// The knot span of a parameter: knots[span] <= parameter < knots[span + 1], the last one for the end.
std::size_t spanOf(const NurbsView& curve, double parameter) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    const auto first = curve.knots.begin() + static_cast<std::ptrdiff_t>(degree);
    const auto last = curve.knots.end() - static_cast<std::ptrdiff_t>(degree) - 1;
    const auto above = std::upper_bound(first, last, parameter);
    if (above != last) {
        return static_cast<std::size_t>(std::max(above, first + 1) - curve.knots.begin()) - 1;
    }
    // The end: the last span that has a length.
    return static_cast<std::size_t>(std::lower_bound(first, last, *last) - curve.knots.begin()) - 1;
}

/// The control points that a span depends on, with their weights multiplied in.
void load(const NurbsView& curve, std::size_t span, Points& points) {
    const std::size_t first = span - static_cast<std::size_t>(curve.degree);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(curve.degree); ++i) {
        points[i] = homogeneous(curve.controls[first + i]);
    }
}

/// One step of de Boor's scheme: `step` counts from 1 to the degree, after which points[degree] is the result. Points
/// before `step` are of no use any more.
void deBoorStep(const NurbsView& curve, std::size_t span, std::size_t step, double parameter, Points& points) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    for (std::size_t i = degree; i >= step; --i) {
        const double low = curve.knots[span - degree + i];
        const double high = curve.knots[span + 1 + i - step];
        points[i] = between(points[i - 1], points[i], (parameter - low) / (high - low));
    }
}

double clamped(const NurbsView& curve, double parameter) {
    return std::clamp(parameter, curve.from(), curve.to());
}

/// The polar form of one piece: what the scheme gives when each of its steps has a parameter of its own.
Homogeneous polarForm(const NurbsView& curve, std::size_t span, std::span<const double> parameters, Points& points) {
    load(curve, span, points);
    for (std::size_t step = 1; step <= parameters.size(); ++step) {
        deBoorStep(curve, span, step, parameters[step - 1], points);
    }
    return points[parameters.size()];
}

std::string faultInKnots(const NurbsView& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    const std::span<const double> knots = curve.knots;
    if (!std::ranges::all_of(knots, [](double knot) { return std::isfinite(knot); }) ||
        !std::ranges::is_sorted(knots)) {
        return "whose knots do not rise";
    }
    if (knots.front() == knots.back()) {
        return "whose knots are all equal";
    }
    if (knots[degree] != knots.front() || knots[knots.size() - 1 - degree] != knots.back()) {
        return "that is not clamped: its first and last knot must be there degree + 1 times";
    }
    for (std::size_t i = 1; i + degree + 1 < knots.size(); ++i) {
        if (knots[i] == knots[i + degree]) {
            return "with a knot more often than its degree inside";
        }
    }
    return {};
}

}  // namespace

std::string faultIn(const NurbsView& curve) {
    constexpr double kMostRatio = 1e6;
    if (curve.degree < 1 || curve.degree > kMostDegree) {
        return "of a degree that is not from 1 to " + std::to_string(kMostDegree);
    }
    if (curve.controls.size() < static_cast<std::size_t>(curve.degree) + 1) {
        return "with fewer control points than its degree + 1";
    }
    if (curve.knots.size() != curve.controls.size() + static_cast<std::size_t>(curve.degree) + 1) {
        return "whose knots are not as many as its control points + its degree + 1";
    }
    if (std::string fault = faultInKnots(curve); !fault.empty()) {
        return fault;
    }
    if (!std::ranges::all_of(curve.controls, [](const ControlPoint& c) {
            return std::isfinite(c.at.x) && std::isfinite(c.at.y) && std::isfinite(c.weight) && c.weight > 0;
        })) {
        return "with a control point or weight that is no number, or a weight that is not above 0";
    }
    const auto [least, most] = std::ranges::minmax(curve.controls, {}, &ControlPoint::weight);
    return most.weight / least.weight > kMostRatio ? "whose weights differ by more than a factor of a million" : "";
}

PointD pointOn(const NurbsView& curve, double parameter) {
    const double at = clamped(curve, parameter);
    const std::size_t span = spanOf(curve, at);
    const auto degree = static_cast<std::size_t>(curve.degree);
    Points points(degree + 1);
    load(curve, span, points);
    for (std::size_t step = 1; step <= degree; ++step) {
        deBoorStep(curve, span, step, at, points);
    }
    return projected(points[degree]);
}

CurvePoint derivativesOn(const NurbsView& curve, double parameter) {
    const double at = clamped(curve, parameter);
    const std::size_t span = spanOf(curve, at);
    const auto degree = static_cast<std::size_t>(curve.degree);
    const std::span<const double> u = curve.knots;
    const double n = curve.degree;
    Points points(degree + 1);
    load(curve, span, points);
    // The points of the last two steps before the result differ by what is left to the derivatives.
    Homogeneous second{};
    for (std::size_t step = 1; step < degree; ++step) {
        if (step + 1 == degree) {
            const double before = u[span + 1] - u[span - 1];
            const double after = u[span + 2] - u[span];
            const Homogeneous slopes[2] = {scaled(difference(points[degree - 1], points[degree - 2]), n / before),
                                           scaled(difference(points[degree], points[degree - 1]), n / after)};
            second = scaled(difference(slopes[1], slopes[0]), (n - 1) / (u[span + 1] - u[span]));
        }
        deBoorStep(curve, span, step, at, points);
    }
    const Homogeneous first = scaled(difference(points[degree], points[degree - 1]), n / (u[span + 1] - u[span]));
    deBoorStep(curve, span, degree, at, points);
    return rationalDerivatives(points[degree], first, second);
}

Nurbs partOf(const NurbsView& curve, double from, double to) {
    ASSERT(curve.from() <= from && from < to && to <= curve.to());
    const auto degree = static_cast<std::size_t>(curve.degree);
    Nurbs part{curve.degree, std::vector<double>(degree + 1, from), {}};
    std::ranges::copy_if(curve.knots, std::back_inserter(part.knots), [&](double u) { return from < u && u < to; });
    part.knots.insert(part.knots.end(), degree + 1, to);
    Points points(degree + 1);
    // A control point is the polar form of the knots inside its support, taken on any piece of it: here the last one
    // before the knots that follow.
    for (std::size_t i = 0; i + degree + 1 < part.knots.size(); ++i) {
        const std::span<const double> inside = std::span(part.knots).subspan(i + 1, degree);
        const auto above =
            std::ranges::find_if(std::span(part.knots).subspan(i), [&](double u) { return u > part.knots[i]; });
        const Homogeneous control = polarForm(curve, spanOf(curve, (part.knots[i] + *above) / 2), inside, points);
        part.controls.push_back({projected(control), control.w});
    }
    return part;
}

std::vector<Bezier> bezierPieces(const NurbsView& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    std::vector<Bezier> pieces;
    std::vector<double> parameters(degree);
    Points points(degree + 1);
    for (std::size_t span = degree; span + degree + 1 < curve.knots.size(); ++span) {
        const double from = curve.knots[span];
        const double to = curve.knots[span + 1];
        if (from == to) {
            continue;
        }
        std::vector<Homogeneous> controls;
        for (std::size_t i = 0; i <= degree; ++i) {
            std::fill(parameters.begin(), parameters.end(), from);
            std::fill_n(parameters.begin(), i, to);
            controls.push_back(polarForm(curve, span, parameters, points));
        }
        // Pieces meet in the very same point.
        controls.front() = pieces.empty() ? homogeneous(curve.controls.front()) : pieces.back().controls().back();
        controls.back() = to == curve.to() ? homogeneous(curve.controls.back()) : controls.back();
        pieces.emplace_back(std::move(controls), from, to);
    }
    return pieces;
}

}  // namespace model
