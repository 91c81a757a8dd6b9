#pragma once

#include <optional>
#include <string>

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// Why a region is none: "the outline crosses itself", and where, in nm.
struct LoopFault {
    std::string what;
    PointD at;
};

/// The first place where loops are not closed, touch or cross themselves or each other (edges that are not neighbours
/// nearer than 1 nm, neighbours that fold back or meet again), or where a hole lies outside the outline or in another
/// hole. Costs much less than a microsecond for simple outlines, n log n for large ones.
[[nodiscard]] std::optional<LoopFault> findFault(const EdgeLoops& loops);

}  // namespace model
