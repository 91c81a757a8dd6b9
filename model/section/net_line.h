#pragma once

#include <vector>

#include "model/base/result.h"
#include "model/measure/items.h"

namespace model {

/// A line along a net, and on which layer of the board each of its legs runs.
struct NetLine {
    std::vector<PointD> line;     ///< corners, nm of the board
    std::vector<LayerId> layers;  ///< one less
};

/// A part of an unrolled line that stays on one layer; lengths along the line.
struct LayerRun {
    double from = 0.0;
    double to = 0.0;
    LayerId layer;
    bool operator==(const LayerRun&) const = default;
};
[[nodiscard]] std::vector<LayerRun> runsOf(const NetLine& line);

/// A line that follows a net, for a section unrolled along it: the longest chain of its tracks, which are connected
/// where they end at one location (as they do at vias and where a track bends). Where they form loops, the shortest
/// path between two ends that are far apart. Arcs become chords of 5 degrees at most. Corners are in nm of the board.
/// Errors: BadUsage for a net without tracks.
[[nodiscard]] base::Result<NetLine> lineAlong(const BoardIndex& index, NetOfCopy net);

}  // namespace model
