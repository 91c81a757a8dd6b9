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

/// The edges of a curve that is part of a shape, marked as such.
[[nodiscard]] std::vector<Edge> edgesOf(const NurbsView& curve);

/// Calls `visit` for the edges of a closed path in their order, curves by what they are measured by.
template <class Visit>
void forEachEdge(const PathNodes& path, const Visit& visit) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path[i].edge != EdgeKind::Curve) {
            visit(edgeOf(path[i], path.endOf(i)));
            continue;
        }
        for (const Edge& edge : edgesOf(path.curveAt(i))) {
            visit(edge);
        }
    }
}

}  // namespace model
