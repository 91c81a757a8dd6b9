#pragma once

#include <optional>

#include "model/index/board_index.h"
#include "model/measure/items.h"

/// What is straight or round about an element where a pointer is. Places are nm of the board. The cost follows what
/// lies within reach, once BoardIndex::figures knows the element.
namespace model {

/// A circle, or an arc of one.
struct Round {
    PointD centre;
    double radius = 0.0;
    PointD on;  ///< the point of the circle that is nearest to the location
};

/// Of discs, holes and rings the rim nearest to the location, however far, and of oval pads that of the nearer end; of
/// others the arc nearest to it: the middle line of a track, its round end where the location is beyond it, or a side
/// of an area. Nothing if what is nearest is straight, a NURBS curve, which has no one radius, or farther away than
/// `reach`.
[[nodiscard]] std::optional<Round> roundAt(const BoardIndex& index, BoardElement element, PointD location,
                                           double reach);

/// The straight middle line of a track, or side of an area, that is nearest to the location. Nothing if what is nearest
/// is curved, a dot, or farther away than `reach`.
[[nodiscard]] std::optional<Edge> straightAt(const BoardIndex& index, BoardElement element, PointD location,
                                             double reach);

/// Where the lines through two straight edges cross. Nothing if they are parallel, or cross beyond
/// base::kMaxCoordinate.
[[nodiscard]] std::optional<PointD> linesCross(const Edge& a, const Edge& b);

/// Between two directions, 0 to 180 degrees.
[[nodiscard]] double angleDeg(PointD u, PointD v);

}  // namespace model
