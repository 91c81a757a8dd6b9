#pragma once

#include <cstdint>
#include <vector>

#include "model/board/document.h"

namespace model {

/// Panels hold a step once and place it often, and steps so placed may hold others: a tree without cycles whose parts
/// are shared. Here it is laid out flat.

/// One document placed on the board: the board itself, or a copy of a step, at whatever depth.
struct StepCopy {
    std::uint32_t step = 0;  ///< row of StepTree::steps
    Placement placement;     ///< from that document's coordinates to the board's
    bool isFlipped = false;  ///< what is on a layer lies on Layer::opposite
};

/// Row 0 of both is the board itself. The row of a copy together with the ElementId inside its step names one element
/// of the board: (copy, element) is what picking returns.
struct StepTree {
    std::vector<const Document*> steps;  ///< each document once, in the order of first appearance
    std::vector<StepCopy> copies;        ///< a copy stands before those it holds
};

/// One element of the board: its row inside the step of a copy.
struct BoardElement {
    std::uint32_t copy = 0;
    ElementId element;
    constexpr auto operator<=>(const BoardElement&) const = default;
};

/// One net of the board: its row inside a document of the tree. It lies wherever that document is placed.
struct BoardNet {
    std::uint32_t step = 0;  ///< row of StepTree::steps
    NetId net;
    constexpr auto operator<=>(const BoardNet&) const = default;
};

/// Does a layer of a flipped copy have no counterpart to lie on?
[[nodiscard]] bool isMirroredInCopy(const Document& step, LayerId layer, bool isFlipped);
/// From where to where on the board lies what is on a layer of a step, in a copy: an upright one has the heights of the
/// layer, a flipped one those of Layer::opposite, or mirrored through the board (boardHeights) where that is none.
[[nodiscard]] ZRange heightsInCopy(const Document& step, LayerId layer, bool isFlipped);
/// The same from the outer face of one layer to that of another, in either order.
[[nodiscard]] ZRange heightsInCopy(const Document& step, LayerId from, LayerId to, bool isFlipped);
/// The same of an element, with its own height if it is the body of a component.
[[nodiscard]] ZRange heightsInCopy(const Document& step, ElementId element, bool isFlipped);
/// Do the bodies of a layer grow down from their board in a copy, from the upper face of where the layer lies?
[[nodiscard]] bool growsDownInCopy(const Document& step, LayerId layer, bool isFlipped);

[[nodiscard]] StepTree unfoldCopies(const Document& board);

/// Every document once, the board itself first.
[[nodiscard]] std::vector<const Document*> distinctSteps(const Document& board);

}  // namespace model
