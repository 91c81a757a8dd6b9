#pragma once

#include <span>
#include <vector>

#include "model/geometry/shapes.h"

namespace model {

/// Outlines of pads and symbols, centred on the origin, lengths in nanometres; every function adds contours to a
/// sketch. Curves are exact arcs, counter-clockwise.

enum class CornerStyle { Rounded, Chamfered };

/// Corners are counted counter-clockwise from the top right: bit 0 top right, 1 top left, 2
/// bottom left, 3 bottom right.
inline constexpr unsigned kAllCorners = 0xF;

void addBox(ShapeSketch& sketch, double width, double height, bool isHole);
void addBox(ShapeSketch& sketch, const Box& box);
/// A box whose chosen corners are cut or rounded by `radius`, which is limited to half the smaller side.
void addCornerBox(ShapeSketch& sketch, double width, double height, double radius, unsigned corners, CornerStyle style,
                  bool isHole);
/// A stadium: both short sides are half circles.
void addOval(ShapeSketch& sketch, double width, double height, bool isHole);
void addDisc(ShapeSketch& sketch, double diameter, bool isHole);
/// An ellipse has no exact arcs: a polygon no further than 0.5 µm from it.
void addEllipse(ShapeSketch& sketch, double width, double height);
void addLoop(ShapeSketch& sketch, std::span<const PointD> points, bool isHole);
/// A corner of a straight-sided outline. A radius rounds it by an arc that touches both sides, limited to half of the
/// shorter one; inward corners are filled the same way.
struct Corner {
    PointD point;
    double radius = 0.0;
};
/// Corners of an island, counter-clockwise.
void addRoundedLoop(ShapeSketch& sketch, std::span<const Corner> corners);
/// A track with round ends: two lines and two half circles. A width of 0 or less adds nothing.
void addCapsule(ShapeSketch& sketch, PointD from, PointD to, double width);
/// Adds nodes as one contour, without those whose straight edge has no length.
void addPath(ShapeSketch& sketch, std::span<const PathNode> nodes, bool isHole);

/// Has one of its contours more than base::kMostCorners corners? Readers leave it out.
[[nodiscard]] bool hasTooManyCorners(const ShapeSketch& sketch);

/// Around the contours of a sketch.
[[nodiscard]] Box boxOf(const ShapeSketch& sketch);

/// Corners of the convex hull, counter-clockwise.
[[nodiscard]] std::vector<Point> convexHull(std::vector<Point> points);

[[nodiscard]] Point rounded(PointD p);

}  // namespace model
