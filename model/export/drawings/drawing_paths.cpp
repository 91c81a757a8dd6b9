#include "model/export/drawings/drawing_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/units.h"
#include "model/geometry/vectors.h"
#include "model/text/number_text.h"

namespace model {

namespace {

constexpr double kMostErrorNm = 10.0;

PointD around(const Edge& arc, double angle) {
    return {arc.centre.x + arc.radius * std::cos(angle), arc.centre.y + arc.radius * std::sin(angle)};
}

/// The largest distance between an arc of this sweep and its Bézier curve, as a part of the radius.
double curveError(double sweep) {
    const double sine = std::sin(sweep / 4);
    const double cosine = std::cos(sweep / 4);
    return 2.0 / 27.0 * std::pow(sine, 6) / (cosine * cosine);
}

}  // namespace

void appendMm(std::string& out, double nm) {
    appendNumber(out, nm / base::kNmPerMm, 7);
}

double sweepOf(const Edge& arc) {
    constexpr double kTurn = 2 * std::numbers::pi;
    if (arc.isFullCircle()) {
        return arc.isClockwise ? -kTurn : kTurn;
    }
    const PointD a = minus(arc.a, arc.centre);
    const PointD b = minus(arc.b, arc.centre);
    const double turned = std::atan2(cross(a, b), dot(a, b));
    if (arc.isClockwise) {
        return turned > 0.0 ? turned - kTurn : turned;
    }
    return turned < 0.0 ? turned + kTurn : turned;
}

std::vector<Edge> piecesOf(const Edge& arc, int count) {
    const double sweep = sweepOf(arc);
    const PointD from = minus(arc.a, arc.centre);
    const double start = std::atan2(from.y, from.x);
    std::vector<Edge> pieces(static_cast<std::size_t>(count), arc);
    for (int i = 1; i < count; ++i) {
        const PointD p = around(arc, start + sweep * i / count);
        pieces[static_cast<std::size_t>(i) - 1].b = p;
        pieces[static_cast<std::size_t>(i)].a = p;
    }
    return pieces;
}

std::vector<Edge> shortPiecesOf(const Edge& edge, double mostSweep) {
    if (!edge.isArc()) {
        return {edge};
    }
    return piecesOf(edge, std::max(1, static_cast<int>(std::ceil(std::abs(sweepOf(edge)) / mostSweep - 1e-3))));
}

std::vector<Curve> curvesOf(const Edge& arc) {
    const double sweep = sweepOf(arc);
    int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 2) - 1e-9)));
    while (arc.radius * curveError(sweep / count) > kMostErrorNm) {
        ++count;
    }
    const double reach = 4.0 / 3.0 * std::tan(sweep / count / 4);
    std::vector<Curve> curves;
    for (const Edge& piece : piecesOf(arc, count)) {
        const PointD a = minus(piece.a, piece.centre);
        const PointD b = minus(piece.b, piece.centre);
        curves.push_back({piece.a,
                          {piece.a.x - reach * a.y, piece.a.y + reach * a.x},
                          {piece.b.x + reach * b.y, piece.b.y - reach * b.x},
                          piece.b});
    }
    return curves;
}

}  // namespace model
