#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/base/point.h"
#include "model/geometry/bezier.h"

namespace model {

/// A rational B-spline curve in the plane (NURBS), as a view of flat rows. The knots have no unit, points are in
/// nanometres. Source: Piegl and Tiller, The NURBS Book; the knot vector is the full one, `degree` + 1 equal knots at
/// either end. Nothing here calls itself: curves of any degree take the room of their degree, not a depth of calls.
struct NurbsView {
    int degree = 0;
    std::span<const double> knots;  ///< controls.size() + degree + 1 of them
    std::span<const ControlPoint> controls;

    [[nodiscard]] double from() const { return knots[static_cast<std::size_t>(degree)]; }
    [[nodiscard]] double to() const { return knots[knots.size() - 1 - static_cast<std::size_t>(degree)]; }
};

/// A curve that owns its rows.
struct Nurbs {
    int degree = 0;
    std::vector<double> knots;
    std::vector<ControlPoint> controls;

    [[nodiscard]] NurbsView view() const { return {degree, knots, controls}; }
};

/// Up to this degree a curve is evaluated in fixed arrays; above, memory is taken for each evaluation.
inline constexpr int kMostFixedDegree = 15;
/// Of curves that are read: sums of products of higher ones lose digits.
inline constexpr int kMostDegree = 30;

/// Why the rows are no curve, in words that end a sentence beginning with "a curve"; empty if they are one. A curve has
/// a degree from 1 to kMostDegree, rising finite knots that differ at both ends, none inside more than `degree` times,
/// clamped ends, finite control points and positive weights that differ by a factor of a million at most.
[[nodiscard]] std::string faultIn(const NurbsView& curve);

/// The point at a parameter from `from()` to `to()`; outside of these the nearer end's.
[[nodiscard]] PointD pointOn(const NurbsView& curve, double parameter);

/// A point and the first two derivatives by the parameter, in nm per unit of it.
struct CurvePoint {
    PointD point;
    PointD first;
    PointD second;
};
/// At an inner knot: those of the piece that follows.
[[nodiscard]] CurvePoint derivativesOn(const NurbsView& curve, double parameter);

/// The piece between two parameters, `from` < `to`, as a curve of its own with the same parameters.
[[nodiscard]] Nurbs partOf(const NurbsView& curve, double from, double to);

/// The same curve as Bézier pieces, one between each two different knots; their parameters run over those knots.
[[nodiscard]] std::vector<Bezier> bezierPieces(const NurbsView& curve);

}  // namespace model
