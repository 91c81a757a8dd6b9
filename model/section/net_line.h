#pragma once

#include <vector>

#include "model/base/result.h"
#include "model/measure/items.h"

namespace model {

/// A line that follows a net, for a section unrolled along it: the longest chain of its tracks, which are connected
/// where they end at one location (as they do at vias and where a track bends). Where they form loops, the shortest
/// path between two ends that are far apart. Arcs become chords of 5 degrees at most. Corners are in nm of the board.
/// Errors: BadUsage for a net without tracks.
[[nodiscard]] base::Result<std::vector<PointD>> lineAlong(const BoardIndex& index, NetOfCopy net);

}  // namespace model
