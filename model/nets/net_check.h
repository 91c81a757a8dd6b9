#pragma once

#include "model/nets/net_ties.h"

namespace model {

/// A connected part of a net.
struct NetIsland {
    ElementId element;  ///< its first piece, in document order
    LayerId layer;      ///< of that element
    PointD location;    ///< of a pad or hole the middle, else a point of that piece
    std::uint32_t pieceCount = 0;
    std::uint32_t padCount = 0;  ///< pieces that came from pads or are plated holes; 0: loose copper without a use
};

/// A net in several islands: islands[firstIsland] and the following ones, the largest first.
struct OpenNet {
    NetId net;
    std::uint32_t firstIsland = 0;
    std::uint32_t islandCount = 0;
};

/// Two nets that touch, one entry per pair of nets and layer.
struct ShortedNets {
    NetId a;  ///< the lower row
    NetId b;
    LayerId layer;       ///< where they touch
    ElementId elementA;  ///< the first pair found
    ElementId elementB;
    PointD location;    ///< a point both cover
    ElementId through;  ///< copper without a net that joins them; none when they touch each other
    std::uint32_t contactCount = 0;
    ComponentId component{};  ///< whose pads the two elements are, if one has both; nothing says that it is a net tie
};
/// How they come together: "touch at pads of C1", "are joined by copper without a net between pads of U7"
[[nodiscard]] std::string textOf(const Document& step, const ShortedNets& entry);

/// A pin of a component that has no net, and copper of a net that it touches: directly, or by more copper without a
/// net.
struct PinOnNet {
    PinId pin;
    NetId net;         ///< the first one found
    ElementId pad;     ///< of the pin
    ElementId copper;  ///< of the net
    LayerId layer;     ///< where that copper is touched
    PointD location;
};
/// "U1.3 has no net and touches VCC"
[[nodiscard]] std::string textOf(const Document& step, const PinOnNet& entry);

/// How the copper of a board differs from its nets. Only copper and plated holes count; copper without a net belongs to
/// no net, but may join two. Where a net tie joins them (NetTies) it is listed, and no short. Pads that a part joins
/// inside (jumperGroups) are connected, if they are of one net.
struct NetReport {
    std::vector<OpenNet> opens;  ///< by net
    std::vector<NetIsland> islands;
    std::vector<ShortedNets> shorts;   ///< by nets and layer
    std::vector<NetTie> ties;          ///< by component and layer
    std::vector<PinOnNet> pinsOnNets;  ///< by pin, each once
    [[nodiscard]] std::span<const NetIsland> islandsOf(const OpenNet& open) const {
        return std::span(islands).subspan(open.firstIsland, open.islandCount);
    }
};

[[nodiscard]] NetReport checkNets(const Document& document, const Connectivity& connectivity);

/// Does a net fall apart where it matters: are there several islands with pads or holes? Else the rest is loose copper.
[[nodiscard]] bool hasSeveralPadIslands(const NetReport& report, const OpenNet& open);

/// What the check found in one step.
struct StepCheck {
    const Document* step = nullptr;
    std::size_t islandCount = 0;
    NetReport report;
};

/// Checks every step of a board once; rows as in StepTree::steps. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<StepCheck>> checkAllNets(const Document& board, base::Progress& progress);

}  // namespace model
