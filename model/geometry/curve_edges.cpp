#include "model/geometry/curve_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/geometry/bernstein.h"
#include "model/geometry/nurbs.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// Arcs that are flatter lose digits: their centres lie too far away.
constexpr double kLargestRadius = 1e11;  // nm

/// The arc through both ends and the middle of a piece; none if it is more than half a circle or too flat.
std::optional<Edge> arcThrough(const Bezier& piece) {
    Edge arc;
    arc.a = piece.start();
    arc.b = piece.end();
    const PointD b = minus(arc.b, arc.a);
    const PointD m = minus(piece.at((piece.from() + piece.to()) / 2).point, arc.a);
    const double turn = cross(b, m);
    const PointD across = {m.y * dot(b, b) - b.y * dot(m, m), b.x * dot(m, m) - m.x * dot(b, b)};
    if (std::abs(turn) * kLargestRadius * 2 < length(across) || std::abs(turn) * 2 > dot(b, b)) {
        return std::nullopt;
    }
    arc.centre = {arc.a.x + across.x / (2 * turn), arc.a.y + across.y / (2 * turn)};
    arc.radius = length(minus(arc.a, arc.centre));
    arc.isClockwise = turn > 0;
    return arc;
}

/// Is the piece nowhere farther from the circle? |d² - r²| = |d - r| (d + r), d the distance from the centre.
bool staysNear(const Bezier& piece, const Edge& arc, double tolerance) {
    double weight = piece.controls().front().w;
    for (const Homogeneous& control : piece.controls()) {
        weight = std::min(weight, control.w);
    }
    const double bound = tolerance * (2 * arc.radius - tolerance) * weight * weight;
    return arc.radius > tolerance && std::ranges::all_of(besideCircle(piece, arc.centre, arc.radius),
                                                         [=](double beside) { return std::abs(beside) <= bound; });
}

/// The line or arc for a piece, if one is near enough.
std::optional<Edge> edgeFor(const Bezier& piece, double tolerance) {
    if (piece.boundOnChord() <= tolerance) {
        Edge line;
        line.a = piece.start();
        line.b = piece.end();
        return line;
    }
    if (piece.runsAlongChord()) {
        const std::optional<Edge> arc = arcThrough(piece);
        if (arc && staysNear(piece, *arc, tolerance)) {
            return arc;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<Edge> edgesAlong(std::span<const Bezier> pieces, double tolerance) {
    std::vector<Edge> edges;
    std::optional<Edge> found;
    const auto isFine = [&](const Bezier& piece) { return (found = edgeFor(piece, tolerance)).has_value(); };
    subdivide(pieces, isFine, [&](const Bezier& piece) {
        // Where halving ends without an edge, the piece is shorter than double can tell.
        Edge edge;
        edge.a = piece.start();
        edge.b = piece.end();
        edge = found.value_or(edge);
        found.reset();
        if (edge.a != edge.b) {
            edges.push_back(edge);
        }
    });
    return edges;
}

std::vector<Edge> edgesOf(const NurbsView& curve) {
    std::vector<Edge> edges = edgesAlong(bezierPieces(curve), kMeasured);
    for (Edge& edge : edges) {
        edge.isOfCurve = true;
    }
    if (!edges.empty()) {
        edges.front().isCurveStart = true;
        edges.back().isCurveEnd = true;
        // The very points where the neighbours in the contour end: a weight divided out may leave another last bit.
        edges.front().a = curve.controls.front().at;
        edges.back().b = curve.controls.back().at;
    }
    return edges;
}

}  // namespace model
