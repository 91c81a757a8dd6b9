#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/shapes.h"

namespace model::formats {

/// A line or arc that an outline is drawn with; no curves.
struct OutlineTrack {
    PathNode from;
    Point to;
};

/// A piece of an outline that no line draws.
struct OutlineGap {
    Point from;
    Point to;
};

/// A loop that becomes closed by straight lines across its gaps.
struct BridgedLoop {
    std::vector<PathNode> nodes;
    std::vector<OutlineGap> gaps;  ///< at least one
    std::size_t trackCount = 0;    ///< so many of the tracks are in it
};

/// The loops of an outline that nobody closed. Tracks are chained in any order and direction where their ends are
/// within `joint` nm. Then ends of chains face each other if each is the other's nearest by far: the next end is half
/// as far again. These are joined, nearest first, until nothing is left that faces. No loop is more gap than drawn: its
/// gaps together are no longer than half of its lines. Nothing where there are so many ends that it is a drawing.
[[nodiscard]] std::vector<BridgedLoop> bridgedLoops(std::span<const OutlineTrack> tracks, double joint);

/// "the board's outline is open by 0.20 mm at (30.00, -0.10) mm; a straight line closes it"
[[nodiscard]] std::string gapsText(const BridgedLoop& loop);

}  // namespace model::formats
