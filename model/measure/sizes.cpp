#include "model/measure/sizes.h"

#include <array>
#include <cmath>
#include <numbers>

#include "model/geometry/vectors.h"
#include "model/statistics/element_sizes.h"

namespace model {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

Sizes sizesOfArc(const ArcGeometry& arc) {
    const Edge edge = edgeOf(arc.node, arc.end);
    Sizes sizes;
    sizes.width = arc.width;
    sizes.length = lengthOf(edge);
    if (edge.isArc()) {
        sizes.radius = edge.radius;
    }
    return sizes;
}

Sizes sizesOfCircle(const CircleGeometry& circle, bool isHole) {
    Sizes sizes;
    sizes.diameter = circle.diameter;
    sizes.radius = circle.diameter / 2.0;
    if (circle.innerDiameter > 0 && (!isHole || circle.innerDiameter < circle.diameter)) {
        sizes.innerDiameter = circle.innerDiameter;
    }
    return sizes;
}

bool isStraight(const Edge& edge) {
    return !edge.isArc() && lengthOf(edge) > 0;
}

bool isTrack(const BoardIndex& index, BoardElement at) {
    const ElementKind kind = index.stepOf(at.copy).elements.kind[at.element.row()];
    return kind == ElementKind::Line || kind == ElementKind::Trail;
}

/// The tracks of two tables whose middles are nearest to each other.
std::pair<Edge, Edge> nearestEdges(const FigureTable& a, const FigureTable& b) {
    std::pair<Edge, Edge> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (Edge e : a.edges(0)) {
        for (Edge f : b.edges(0)) {
            e.pen = f.pen = 0.0;
            if (const double distance = spacingBetween(e, f).distance; distance < least) {
                least = distance;
                nearest = {e, f};
            }
        }
    }
    return nearest;
}

}  // namespace

Sizes sizesOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    Sizes sizes;
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: sizes.width = document.lines[row].width; break;
        case ElementKind::Trail: sizes.width = document.trails[row].width; break;
        case ElementKind::Arc: return sizesOfArc(document.arcs[row]);
        case ElementKind::Circle:
            return sizesOfCircle(document.circles[row], (document.elements.flags[element.row()] & kHole) != 0);
        case ElementKind::Area: return sizes;
    }
    sizes.length = lengthOf(document, element);
    return sizes;
}

std::optional<double> angleBetween(const BoardIndex& index, BoardElement a, BoardElement b) {
    if (!isTrack(index, a) || !isTrack(index, b)) {
        return std::nullopt;
    }
    const Pieces piecesA = piecesOf(index, std::array{a});
    const Pieces piecesB = piecesOf(index, std::array{b});
    if (piecesA.pieces.empty() || piecesB.pieces.empty() || piecesA.figures[0].isFilled ||
        piecesB.figures[0].isFilled) {
        return std::nullopt;
    }
    const auto [e, f] = nearestEdges(piecesA.figures, piecesB.figures);
    if (!isStraight(e) || !isStraight(f)) {
        return std::nullopt;
    }
    const PointD u = minus(e.b, e.a);
    const PointD v = minus(f.b, f.a);
    return std::atan2(std::abs(cross(u, v)), std::abs(dot(u, v))) * kDegreesPerRadian;
}

}  // namespace model
