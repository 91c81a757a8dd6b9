#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "model/base/point.h"

namespace model {

using base::PointD;

/// Of a rational curve: what it is drawn towards, and how strongly.
struct ControlPoint {
    PointD at;  ///< nm
    double weight = 1.0;
    constexpr bool operator==(const ControlPoint&) const = default;
};

/// A control point with its weight multiplied in: rational curves are plain ones of these, seen from 0, 0, 0.
struct Homogeneous {
    double x;
    double y;
    double w;
};

constexpr Homogeneous homogeneous(const ControlPoint& c) {
    return {c.at.x * c.weight, c.at.y * c.weight, c.weight};
}
constexpr PointD projected(const Homogeneous& h) {
    return {h.x / h.w, h.y / h.w};
}
constexpr Homogeneous between(const Homogeneous& a, const Homogeneous& b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.w + (b.w - a.w) * t};
}
constexpr Homogeneous difference(const Homogeneous& a, const Homogeneous& b) {
    return {a.x - b.x, a.y - b.y, a.w - b.w};
}
constexpr Homogeneous scaled(const Homogeneous& h, double by) {
    return {h.x * by, h.y * by, h.w * by};
}

struct CurvePoint;
/// From those of the homogeneous curve, by the quotient rule.
[[nodiscard]] CurvePoint rationalDerivatives(const Homogeneous& value, const Homogeneous& first,
                                             const Homogeneous& second);

/// One rational Bézier curve: a piece of a NURBS curve without a knot inside. It lies in the convex hull of its control
/// points, since all weights are positive; all bounds here come from that.
class Bezier {
public:
    /// `from` and `to` are the parameters of its ends on the curve it is a piece of.
    Bezier(std::vector<Homogeneous> controls, double from, double to);

    [[nodiscard]] std::span<const Homogeneous> controls() const { return m_controls; }
    [[nodiscard]] std::size_t degree() const { return m_controls.size() - 1; }
    [[nodiscard]] double from() const { return m_from; }
    [[nodiscard]] double to() const { return m_to; }
    [[nodiscard]] PointD start() const { return projected(m_controls.front()); }
    [[nodiscard]] PointD end() const { return projected(m_controls.back()); }
    /// At a parameter from `from` to `to`; derivatives by that parameter.
    [[nodiscard]] CurvePoint at(double parameter) const;
    /// Both halves; `before` takes the place of this one.
    [[nodiscard]] Bezier splitInMiddle();

    /// No point of the curve lies farther than this from the straight line between its ends, and none of that line
    /// farther from the curve. At most 1/(1 - 2^(1 - degree)) times too large once the curve is nearly straight.
    [[nodiscard]] double boundOnChord() const;
    /// No control point lies farther from the chord.
    [[nodiscard]] double hullBesideChord() const;
    /// The angles between the sides of the control polygon together, in radians: no curve bends by more.
    [[nodiscard]] double bend() const;
    /// Do the control points follow one another along the chord? Then the curve passes each line across it once.
    [[nodiscard]] bool runsAlongChord() const;

private:
    std::vector<Homogeneous> m_controls;
    double m_from;
    double m_to;
};

/// Calls `visit` for pieces of the curve that `isFine` accepts, in their order; others are halved, down to where
/// parameters no longer differ.
void subdivide(std::span<const Bezier> pieces, const std::function<bool(const Bezier&)>& isFine,
               const std::function<void(const Bezier&)>& visit);

/// Points of the curve, both ends among them, whose chords stay within `tolerance` nm of the curve and it of them: what
/// boundOnChord guarantees. Along none the curve bends by more than `mostBend`, in radians.
[[nodiscard]] std::vector<PointD> chordPoints(std::span<const Bezier> pieces, double tolerance,
                                              double mostBend = std::numeric_limits<double>::infinity());

/// The point that curve pieces in a row have at a parameter.
[[nodiscard]] PointD pointAt(std::span<const Bezier> pieces, double parameter);

}  // namespace model
