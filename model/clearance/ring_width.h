#pragma once

#include <span>

#include "model/figures/figures.h"

namespace model {

/// How copper lies to a hole that is drilled through it.
enum class RingState : std::uint8_t {
    Apart,      ///< they have nothing in common, or the copper leaves room for the hole
    BreaksOut,  ///< the outline of the hole crosses that of the copper, or touches it
    Removed,    ///< all of the copper lies within the hole
    Around      ///< the copper surrounds the hole
};

/// The ring that copper leaves around a hole.
struct RingWidth {
    RingState state = RingState::Apart;
    Spacing width;  ///< Around: from the outline of the hole to that of the copper; BreaksOut, and Removed if they
                    ///< touch: 0, where they meet
};

/// What figure `row` of `copper` leaves around a hole (all figures of `hole`, round, slot or area). Outlines of the
/// copper within the hole do not count: the drill takes them. Exact below `below` nm, beyond that the width is infinite
/// or any larger one. Of copper that is a track of several edges each edge counts for itself, and the one that leaves
/// most is the result; a routed hole of several edges keeps the least of what all of them leave, and breaks out where
/// an opening within it spans two of them.
[[nodiscard]] RingWidth ringAround(const FigureTable& hole, const FigureTable& copper, std::size_t row, double below);
/// What several figures leave together: the outline of one that lies within another is none. Exact to a nanometre.
[[nodiscard]] RingWidth ringAround(const FigureTable& hole, const FigureTable& copper,
                                   std::span<const std::uint32_t> rows, double below);

}  // namespace model
