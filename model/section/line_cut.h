#pragma once

#include "model/board/document.h"
#include "model/geometry/discretise.h"
#include "model/geometry/edges.h"
#include "model/section/intervals.h"

/// Where a straight line passes single elements, exactly: arcs are met as arcs, pens as pens. A line that runs along
/// an edge of an area is taken as moved a little to its right, so that it lies on one side of the edge.
namespace model {

/// A line with a direction, in nanometres. Lengths along it are measured from its origin.
struct CutLine {
    PointD origin;
    PointD unit{1.0, 0.0};  ///< direction, of length 1

    [[nodiscard]] static CutLine through(PointD a, PointD b);  ///< from `a`, which is not `b`
    [[nodiscard]] double along(PointD p) const { return (p.x - origin.x) * unit.x + (p.y - origin.y) * unit.y; }
    /// How far to the left of the line.
    [[nodiscard]] double beside(PointD p) const { return (p.y - origin.y) * unit.x - (p.x - origin.x) * unit.y; }
    /// The same line where what is placed has its own coordinates. Lengths along it stay.
    [[nodiscard]] CutLine seenFrom(const Placement& placement) const;
    /// Whether the line comes near a box.
    [[nodiscard]] bool meets(const Box& box) const;
};

/// What an element covers of a line.
struct ElementCut {
    Intervals covered;  ///< all of it; of a hole as far as its drill reaches
    Intervals opening;  ///< what a ring leaves open inside; all of a routed area, whose wall is not known
};

[[nodiscard]] ElementCut cutElement(const Document& document, ElementId element, const CutLine& line);
/// What a shape covers of a line.
[[nodiscard]] Intervals cutShape(const ShapeTable& shapes, ShapeId shape, const CutLine& line);
/// What a shape leaves open of a line within its islands: its holes.
[[nodiscard]] Intervals cutHolesOf(const ShapeTable& shapes, ShapeId shape, const CutLine& line);
/// What polygons cover of a line.
[[nodiscard]] Intervals cutPolygons(const PolygonSet& polygons, const CutLine& line);

}  // namespace model
