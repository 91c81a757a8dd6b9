#include "model/measure/edge_at.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

PointD directionOf(const Edge& edge) {
    return {edge.b.x - edge.a.x, edge.b.y - edge.a.y};
}

/// The edge of an element whose middle is nearest to a location, if it covers the location or comes so near.
std::optional<Edge> nearestEdge(const BoardIndex& index, BoardElement element, PointD location, double reach) {
    const StepCopy& copy = index.tree.copies[element.copy];
    const std::shared_ptr<const FigureTable> kept = index.figuresOf(copy.step, element.element);
    const FigureTable& figures = *kept;
    const PointD there = unplaced(location, copy.placement);
    std::optional<Edge> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < figures.size(); ++row) {
        visitEdges(figures, row, boxAround(there, reach), [&](const Edge& edge) {
            if (const double beside = distance(nearestOn(edge, there), there); beside < least) {
                least = beside;
                nearest = edge;
            }
        });
    }
    return nearest && least <= reach + nearest->pen ? std::optional(placed(*nearest, copy.placement)) : std::nullopt;
}

Round roundOf(PointD centre, double radius, PointD location) {
    const double beside = distance(centre, location);
    const PointD direction =
        beside > 0 ? PointD{(location.x - centre.x) / beside, (location.y - centre.y) / beside} : PointD{1.0, 0.0};
    return {centre, radius, {centre.x + radius * direction.x, centre.y + radius * direction.y}};
}

/// A disc is a dot with a pen, a ring a circle with one.
Round rimOf(const Edge& edge, PointD location) {
    if (!edge.isArc()) {
        return roundOf(edge.a, edge.pen, location);
    }
    const bool isInside = distance(edge.centre, location) < edge.radius;
    return roundOf(edge.centre, isInside ? edge.radius - edge.pen : edge.radius + edge.pen, location);
}

/// The round end of a straight track that a location is beyond; of an oval pad the nearer one.
std::optional<Round> endOf(const Edge& track, PointD location, bool isPad) {
    const bool isAtA = distance(track.a, location) < distance(track.b, location);
    const PointD end = isAtA ? track.a : track.b;
    const PointD other = isAtA ? track.b : track.a;
    const bool isBeyond = dot(minus(location, end), minus(end, other)) > 0;
    return track.pen > 0 && (isBeyond || isPad) ? std::optional(roundOf(end, track.pen, location)) : std::nullopt;
}

}  // namespace

std::optional<Round> roundAt(const BoardIndex& index, BoardElement element, PointD location, double reach) {
    const Document& step = index.stepOf(element.copy);
    const bool isCircle = step.elements.kind[element.element.row()] == ElementKind::Circle;
    const auto edge = nearestEdge(index, element, location, isCircle ? std::numeric_limits<double>::infinity() : reach);
    if (edge && !isCircle && !edge->isArc() && !edge->isOfCurve) {
        return endOf(*edge, location, (step.elements.flags[element.element.row()] & kPad) != 0);
    }
    if (!edge || edge->isOfCurve) {
        return std::nullopt;
    }
    return isCircle ? rimOf(*edge, location) : Round{edge->centre, edge->radius, nearestOn(*edge, location)};
}

std::optional<Edge> straightAt(const BoardIndex& index, BoardElement element, PointD location, double reach) {
    const auto edge = nearestEdge(index, element, location, reach);
    return edge && !edge->isArc() && !edge->isOfCurve && lengthOf(*edge) > 0 ? edge : std::nullopt;
}

std::optional<PointD> linesCross(const Edge& a, const Edge& b) {
    const PointD u = directionOf(a);
    const PointD v = directionOf(b);
    const double across = cross(u, v);
    if (across == 0.0) {
        return std::nullopt;
    }
    const double part = cross({b.a.x - a.a.x, b.a.y - a.a.y}, v) / across;
    const PointD at = {a.a.x + part * u.x, a.a.y + part * u.y};
    const bool isNear = std::max(std::abs(at.x), std::abs(at.y)) <= base::kMaxCoordinate;
    return isNear ? std::optional(at) : std::nullopt;
}

double angleDeg(PointD u, PointD v) {
    return std::atan2(std::abs(cross(u, v)), u.x * v.x + u.y * v.y) * 180.0 / std::numbers::pi;
}

}  // namespace model
