#pragma once

#include <vector>

#include "model/geometry/discretise.h"

namespace render {

/// A round hole of a shape that is drawn by a let (shader::kLetHole) instead of being triangulated: the shape's polygon
/// leaves a square cell around it free, which the let fills up to the circle.
struct RoundHole {
    model::Point centre;   ///< nm, in the shape's coordinates
    model::Nm radius = 0;  ///< of the circle
    model::Nm cell = 0;    ///< half the side of the square
};

/// How far the square reaches beyond the circle: the coarsest ring of a let stands out of its circle by 1/25.
[[nodiscard]] constexpr model::Nm cellAround(model::Nm radius) {
    return radius + radius / 16 + 2'000;
}

[[nodiscard]] model::Box cellOf(const RoundHole& hole);

/// A shape as polygons, with square cells in place of round holes that stand alone.
struct PunchedShape {
    model::PolygonSet polygons;
    std::vector<RoundHole> holes;
};

/// Takes out the round holes whose cell lies in the shape with all its edges and touches no other contour; the others
/// become chords like everything else. The result covers what `model::discretise` covers, but for the chords of
/// circles.
[[nodiscard]] PunchedShape punch(const model::ShapeTable& shapes, model::ShapeId shape,
                                 const model::Discretisation& how);

}  // namespace render
