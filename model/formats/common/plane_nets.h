#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/board/document.h"
#include "model/geometry/discretise.h"

/// Which nets the pieces of a negative layer belong to. Jobs name nets for features only, and those of a negative
/// layer are what is not copper; so a piece has the net of what touches it.
namespace model::formats {

/// A location that belongs to a net. The copper around it has that net.
struct NetVote {
    Point location;
    NetId net;
};

/// The votes on a layer: middles of plated holes that pass it, and of its own pads. A hole that is kept clear, and the
/// pad that keeps it so, lie outside of all copper and do not count; a thermal pad leaves copper in its middle.
[[nodiscard]] std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures);

/// The net of each polygon and how clear it is.
struct PieceNet {
    NetId net;                   ///< that of most votes inside, the first one of equals; none without votes
    bool hasOtherVotes = false;  ///< votes for other nets lie inside too
};
[[nodiscard]] std::vector<PieceNet> netsOf(const PolygonSet& pieces, std::span<const NetVote> votes);

}  // namespace model::formats
