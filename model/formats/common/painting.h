#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/board/document_builder.h"
#include "model/geometry/discretise.h"
#include "model/geometry/loops/edge_loops.h"
#include "model/geometry/loops/region_booleans.h"

namespace model::formats {

/// Paint order: later features lie over earlier ones, and a negative one takes away what is below it. So what remains
/// of a positive element is its region minus all negative elements after it. `negatives` has one entry per element of
/// the document.

/// What is left has exact lines and arcs, on the grid of 1 nm (region_booleans.h). Where there is no exact result its
/// edges are straight, within 1 µm, and functions here say so.

/// Copies the positive elements of `painted` to the builder's current layer. Those that no later negative touches stay
/// as they are; what is left of the others becomes a painted Area with the same net, symbol and feature; its sources
/// are that feature and the negative ones over its box. Reports with `file` how many areas are not exact.
void addPainted(DocumentBuilder& builder, const Document& painted, std::span<const std::uint8_t> negatives,
                std::string_view file);

/// What an element of `document` has besides its geometry, for a copy in what the builder makes.
[[nodiscard]] DocumentBuilder::Origin originOf(DocumentBuilder& builder, const Document& document, std::size_t row);

/// Jobs name nets for features only, and those of a negative layer are what is not copper; so a piece of it has the net
/// of what touches it.

/// A location that belongs to a net. The copper around it has that net.
struct NetVote {
    Point location;
    NetId net;
    Nm radius = 0;  ///< of the round hole around it; where it cuts copper counts if its middle lies in none
};

/// The votes on a layer: plated holes that pass it, and middles of its own pads. A hole that is kept clear, and the
/// pad that keeps it so, cut no copper and do not count; a thermal pad leaves copper in its middle, or clears less than
/// what is drilled (Allegro, where a hole joins its plane all around).
[[nodiscard]] std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures);

/// The net of each polygon and how clear it is.
struct PieceNet {
    NetId net;                   ///< that of most votes inside, the first one of equals; none without votes
    bool hasOtherVotes = false;  ///< votes for other nets lie inside too
};
[[nodiscard]] std::vector<PieceNet> netsOf(const PolygonSet& pieces, std::span<const NetVote> votes);

/// How the pieces of a negative layer got their nets.
struct InverseSummary {
    std::size_t pieces = 0;
    std::size_t withoutNet = 0;
    std::size_t withSeveralNets = 0;  ///< votes for several nets lie in one piece
    bool isExact = true;
};

/// The copper of a negative layer.
struct Inverse {
    struct Piece {
        ShapeSketch sketch;
        NetId net;                            ///< that of the votes in it
        std::vector<std::uint32_t> features;  ///< that shaped its outline, rising
    };
    std::vector<Piece> pieces;  ///< connected each
    InverseSummary summary;
};

/// What all positive elements leave visible, each by itself.
[[nodiscard]] RegionBoolean visibleOf(const Document& painted, std::span<const std::uint8_t> negatives);
/// Base minus what `painted` leaves visible (visibleOf).
[[nodiscard]] Inverse inverseOf(const std::vector<EdgeLoops>& base, const RegionBoolean& visible,
                                const Document& painted, std::span<const NetVote> votes);
/// Adds the pieces to the builder's current layer, a painted Area each.
void addInverse(DocumentBuilder& builder, const Inverse& inverse);

/// The region that all elements together leave visible. Reports with `file` if it is not exact.
[[nodiscard]] ShapeSketch regionOf(const Document& painted, std::span<const std::uint8_t> negatives,
                                   Diagnostics& diagnostics, std::string_view file);

}  // namespace model::formats
