#pragma once

#include <vector>

#include "model/geometry/shapes.h"

namespace model {

/// A straight line or an arc of a circle in nanometres: a piece of a boundary, or the middle of a track. An arc is one
/// true circle: where the job's two radii differ by rounding, `radius` is their mean and the ends stay where they are.
struct Edge {
    PointD a;
    PointD b;             ///< equal to `a`: a dot when straight, a full circle when an arc
    PointD centre;        ///< of an arc
    double radius = 0.0;  ///< of an arc; 0: straight
    double pen = 0.0;     ///< half the width of the track, 0 on boundaries
    bool isClockwise = false;
    bool isHole = false;      ///< part of a hole of its region
    std::int8_t winding = 1;  ///< 1 when its contour runs counter-clockwise, else -1
    bool isOfCurve = false;   ///< stands for a piece of a NURBS curve: its centre and inner ends are nothing on a board
    bool isCurveStart = false;  ///< `a` is where that curve starts
    bool isCurveEnd = false;    ///< `b` is where it ends

    [[nodiscard]] bool isArc() const { return radius > 0.0; }
    [[nodiscard]] bool isFullCircle() const { return isArc() && a.x == b.x && a.y == b.y; }
    /// Are the ends such of an edge of the board?
    [[nodiscard]] bool startsThere() const { return !isOfCurve || isCurveStart; }
    [[nodiscard]] bool endsThere() const { return !isOfCurve || isCurveEnd; }
};

/// Of an edge that is followed from its end to its start: arcs turn the other way.
[[nodiscard]] constexpr EdgeKind reversed(EdgeKind kind) {
    return kind == EdgeKind::ArcClockwise          ? EdgeKind::ArcCounterClockwise
           : kind == EdgeKind::ArcCounterClockwise ? EdgeKind::ArcClockwise
                                                   : kind;
}
/// The edge from a path node to the next point; not for curves, which are many (curve_edges.h).
[[nodiscard]] Edge edgeOf(const PathNode& from, Point to);
/// Where a placed point was before: undoes Placement::apply.
[[nodiscard]] PointD unplaced(PointD p, const Placement& placement);
/// Does the arc pass the direction `v` from its centre?
[[nodiscard]] bool passes(const Edge& arc, PointD v);
/// The same edge laid on the board.
[[nodiscard]] Edge placed(const Edge& edge, const Placement& placement);
/// Smallest box around the edge and its pen, rounded outwards.
[[nodiscard]] Box boxOf(const Edge& edge);

/// The shortest distance between two items. Both ends are the location of contact when `distance` is 0.
struct Spacing {
    double distance = 0.0;
    PointD from;
    PointD to;
};

/// The spacing between two tracks; 0 when they touch or overlap. Errors stay below 1e-3 nm: coordinates are integers of
/// at most 2^30, and double keeps 53 bits of their differences and products.
[[nodiscard]] Spacing spacingBetween(const Edge& a, const Edge& b);

/// The point of the middle line that is nearest to `p`.
[[nodiscard]] PointD nearestOn(const Edge& edge, PointD p);
/// Where two middle lines cross or touch: at most two points; none for lines that run along each other.
[[nodiscard]] std::vector<PointD> crossingsOf(const Edge& a, const Edge& b);
/// Length of the middle line from `a` to a point on it, in the sense in which it runs.
[[nodiscard]] double lengthTo(const Edge& edge, PointD on);
/// Length of the whole middle line.
[[nodiscard]] double lengthOf(const Edge& edge);
/// The point so far along the middle line.
[[nodiscard]] PointD pointAt(const Edge& edge, double delta);

/// How often the edge, closed by nothing else, contributes to the winding number of its contour around `p`: sum over
/// the contour is 0 outside. Points on a chord count to one side in every edge alike.
[[nodiscard]] int windingAround(const Edge& edge, PointD p);

/// What the edge adds to the signed area of its contour, in nm², counter-clockwise positive; `base` is any point used
/// for all edges of the contour.
[[nodiscard]] double areaUnder(const Edge& edge, PointD base);

}  // namespace model
