#pragma once

#include <string>
#include <vector>

#include "model/geometry/edges.h"

/// Numbers and pieces of arcs as drawings want them.
namespace model {

/// Appends millimetres to 0.1 nm.
void appendMm(std::string& out, double nm);

/// From its start to its end in radians, counter-clockwise positive; a full circle is ±2π.
[[nodiscard]] double sweepOf(const Edge& arc);

/// The arc in so many equal pieces; their ends lie on its circle.
[[nodiscard]] std::vector<Edge> piecesOf(const Edge& arc, int count);
/// The edge in pieces that turn no more than that, but for a thousandth; a line is one piece.
[[nodiscard]] std::vector<Edge> shortPiecesOf(const Edge& edge, double mostSweep);

/// A Bézier curve of third degree from `a`.
struct Curve {
    PointD a;
    PointD control1;
    PointD control2;
    PointD b;
};
/// The curves that are nowhere farther than 10 nm from the arc.
[[nodiscard]] std::vector<Curve> curvesOf(const Edge& arc);

}  // namespace model
