#pragma once

#include <optional>
#include <span>

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// What became of a row of tracks.
struct Offset {
    std::optional<EdgeLoops> outline;
    std::size_t brokenAt = 0;  ///< without an outline: the track in the row at whose start the construction failed
};

/// The outline of tracks that are joined end to end with round pens, `Edge::pen` of each: both sides are moved by the
/// pen, joined by arcs where they part and cut where they cross; steps of width follow the circle of the wider pen. No
/// outline when that is not all there is to it: a track too short for its neighbours, sharp bends of small radius,
/// tracks that cross or touch others. Two tracks join where one ends and the next one begins, bit for bit.
[[nodiscard]] Offset offsetOutline(std::span<const Edge> tracks);
/// The same for a row of tracks that ends where it begins: an outline and a hole.
[[nodiscard]] std::optional<EdgeLoops> offsetRing(std::span<const Edge> tracks);

}  // namespace model
