#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/loops/edge_faces.h"

namespace model {

/// The edges of a loop of fragments: runs of one line and of one circle are one edge again, a whole circle is a loop of
/// one edge. `isPinched`, by vertex of the arrangement: loops pass it more than once; there the loop keeps 1.2 nm away.
[[nodiscard]] std::vector<Edge> edgesOf(const EdgeArrangement& arrangement, std::span<const Side> loop,
                                        std::span<const std::uint8_t> isPinched);

}  // namespace model
