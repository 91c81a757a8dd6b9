#pragma once

#include <span>
#include <vector>

#include "model/geometry/bezier.h"
#include "model/geometry/edges.h"

/// Questions about a curve given by its Bézier pieces in a row (nurbs.h, bezierPieces). Lengths are in nanometres.
namespace model {

/// The smallest box around the curve, outwards to whole nanometres; what sticks out by less than 1e-3 nm is not seen.
[[nodiscard]] Box boxOf(std::span<const Bezier> pieces);

/// Length of the curve, to 1e-3 nm or 1e-12 of it.
[[nodiscard]] double lengthOf(std::span<const Bezier> pieces);

/// What the curve adds to the signed area of its contour, as areaUnder of an edge does (edges.h): to 1e-3 nm times its
/// length, or 1e-12 of it.
[[nodiscard]] double areaUnder(std::span<const Bezier> pieces, PointD base);

struct OnCurve {
    PointD point;
    double parameter = 0.0;
    double distance = 0.0;
};
/// The point of the curve nearest to `p`: none is nearer by more than 1e-3 nm.
[[nodiscard]] OnCurve nearestOn(std::span<const Bezier> pieces, PointD p);

/// What the curve adds to the winding number of its contour around `p`, as windingAround of an edge does.
[[nodiscard]] int windingAround(std::span<const Bezier> pieces, PointD p);

/// Where the curve crosses or touches a line or an arc (without its pen), rising by the curve's parameter; to 1e-5 nm
/// across the line, touching as far as 1e-6 nm. None where both run along each other over more than a micrometre.
[[nodiscard]] std::vector<OnCurve> crossingsOf(std::span<const Bezier> pieces, const Edge& edge);

/// Where two curves cross, to 1e-3 nm, in no order. Curves that run along each other give some of the points there.
[[nodiscard]] std::vector<PointD> crossingsOf(std::span<const Bezier> a, std::span<const Bezier> b);

}  // namespace model
