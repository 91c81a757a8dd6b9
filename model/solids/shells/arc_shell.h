#pragma once

#include <optional>
#include <vector>

#include "model/solids/shells/shell.h"

namespace model {

/// The region of a track along an arc: an outer and an inner arc with half circles at its ends; a ring for a full
/// circle; without the inner arc where the pen reaches over the centre. Without a value when the two ends of the track
/// meet, so that it overlaps itself.
[[nodiscard]] std::optional<EdgeLoops> arcOutline(const ArcGeometry& arc);
/// The same as regions, for all arcs: one that overlaps itself is the union of its halves. Without a value when these
/// could not be united.
[[nodiscard]] std::optional<std::vector<EdgeLoops>> arcOutlines(const ArcGeometry& arc);

}  // namespace model
