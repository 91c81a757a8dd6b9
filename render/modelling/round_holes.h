#pragma once

#include <vector>

#include "model/geometry/discretise.h"

namespace render {

/// A round hole of a shape that is drawn by a let (shader::kLetHole) instead of being triangulated: the shape's polygon
/// leaves a rectangular cell around it free, which the let fills up to the circle.
struct RoundHole {
    model::Point centre;   ///< nm, in the shape's coordinates
    model::Nm radius = 0;  ///< of the circle
    model::Box cell;       ///< at least the square around the circle (cellAround)
};

/// How far a cell reaches from the centre at least, beyond the circle: the coarsest ring of a let stands out of its
/// circle by 1/25.
[[nodiscard]] constexpr model::Nm cellAround(model::Nm radius) {
    return radius + radius / 16 + 2'000;
}

/// How far a cell may reach from the centre: what a let can say (shader::kLetHole), less the overlap.
inline constexpr model::Nm kLargestCell = 65'000'000;

/// A shape as polygons, with rectangular fields in place of round holes that stand alone. The cells of its holes tile a
/// field.
struct PunchedShape {
    model::PolygonSet polygons;
    std::vector<RoundHole> holes;
    std::vector<model::Box> fields;  ///< each of them a loop of `polygons`
};

/// Takes out the round holes whose cell lies in the shape with all its edges and touches no other contour; the others
/// become chords like everything else. Holes with nothing but shape around and between them share a field
/// (hole_cells.h). The result covers what `model::discretise` covers, but for the chords of circles.
[[nodiscard]] PunchedShape punch(const model::ShapeTable& shapes, model::ShapeId shape,
                                 const model::Discretisation& how);

}  // namespace render
