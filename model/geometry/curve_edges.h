#pragma once

#include <span>
#include <vector>

#include "model/geometry/bezier.h"
#include "model/geometry/edges.h"

namespace model {

/// What a NURBS curve is measured by: lines and arcs in a row from its start to its end, no point of which lies farther
/// than `tolerance` nm from the curve, nor of the curve from them. Each arc goes through three points of the curve; the
/// tolerance is proved by the Bernstein coefficients of the curve's distance from the circle. About 30 arcs stand for
/// a millimetre of a curve of that size at kMeasured, and their number grows with the third root of its size.
[[nodiscard]] std::vector<Edge> edgesAlong(std::span<const Bezier> pieces, double tolerance);

/// nm: distances between two curves stay within half a nanometre.
inline constexpr double kMeasured = 0.25;

}  // namespace model
