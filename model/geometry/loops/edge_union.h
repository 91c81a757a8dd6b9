#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// Booleans of regions with edges that stay lines and arcs. Results are connected regions that findFault passes: edges
/// of one line or one circle are one edge, vertices nearer than 2 nm are one, what is thinner than 1 nm is closed or
/// left out, and where regions touch themselves at a point 2 nm are left. So edges may move by up to 2 nm where
/// operands run past each other that closely (5 nm where 2 do not lead to a result), and nowhere else. Costs n log n
/// for edges that do not cross more often than that; the order of the operands does not matter.
///
/// No value when the result cannot be relied on.

/// What at least one of the regions covers. Regions that are faulty are cleaned before.
[[nodiscard]] std::optional<std::vector<EdgeLoops>> unite(std::span<const EdgeLoops> regions);
/// What the first ones cover and the others do not; each of both kinds as unite() leaves them.
[[nodiscard]] std::optional<std::vector<EdgeLoops>> subtract(std::span<const EdgeLoops> from,
                                                             std::span<const EdgeLoops> what);
/// A region whose loops touch, cross or overlap: what has a winding number above 0. Slits close, spikes without width
/// vanish.
[[nodiscard]] std::optional<std::vector<EdgeLoops>> cleaned(const EdgeLoops& region);
/// What a drawing of lines and arcs encloses: all that cannot be reached from outside without crossing one of them, as
/// regions without holes, one within another where drawings do not meet. Lines may come in any order and direction,
/// cross, cover each other and lead nowhere.
[[nodiscard]] std::optional<std::vector<EdgeLoops>> enclosedBy(std::span<const Edge> drawing);

}  // namespace model
