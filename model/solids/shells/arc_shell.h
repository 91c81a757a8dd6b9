#pragma once

#include <optional>

#include "model/solids/shells/shell.h"

namespace model {

/// The region of a track along an arc: an outer and an inner arc with half circles at its ends; a ring for a full
/// circle; without the inner arc where the pen reaches over the centre. Without a value when the two ends of the track
/// meet, so that it overlaps itself: then it is the union of its halves.
[[nodiscard]] std::optional<EdgeLoops> arcOutline(const ArcGeometry& arc);

}  // namespace model
