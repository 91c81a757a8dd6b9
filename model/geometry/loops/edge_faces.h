#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/loops/edge_arrangement.h"

namespace model {

/// A fragment of an arrangement in one of its two directions: 2 * row from a to b, 2 * row + 1 from b to a.
using Side = std::uint32_t;

/// The boundary of all that has a winding number above 0, as loops of fragments with the inside on their left: outlines
/// counter-clockwise, holes clockwise, as the fragments lie. Where parts of the inside touch each other at a vertex,
/// loops do not pass from one to the other. Faces thinner than 1 nm count as what lies beside them.
///
/// The faces of the plane follow from the order of fragments around vertices alone. No value when that order
/// contradicts itself (Euler's formula): fragments cross each other by less than what can be told apart.
[[nodiscard]] std::optional<std::vector<std::vector<Side>>> boundaryOf(const EdgeArrangement& arrangement);
/// The outer boundaries of what fragments enclose, whatever their counts are: a loop, counter-clockwise, around all
/// faces that hang together by more than a vertex. Fragments that lead nowhere are part of none. No value as above.
[[nodiscard]] std::optional<std::vector<std::vector<Side>>> outerBoundaryOf(const EdgeArrangement& arrangement);

}  // namespace model
