#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/figures/figures.h"
#include "model/index/board_index.h"

/// What can be measured from and to, and in which pieces it lies on the board.
namespace model {

struct NetOfCopy {
    std::uint32_t copy = 0;
    NetId net;
};
/// The copper pads of a component's pins; of all components that have its designator, since a name does not tell them
/// apart.
struct PartOfCopy {
    std::uint32_t copy = 0;
    ComponentId component;
};
/// The copper pads of one pin, all those of its name (pinsNamedAs), of all components of that name: those the job ties
/// to it, else those of its net where it is.
struct PinOfCopy {
    std::uint32_t copy = 0;
    PinId pin;
};
/// The outline of the board with its cut-outs, a line without width all through the stackup.
struct BoardEdge {};
/// A point; without a layer it is measured in the plane only.
struct Location {
    PointD at;  ///< nm of the board
    LayerId layer;
};
using MeasureItem = std::variant<BoardElement, NetOfCopy, PartOfCopy, PinOfCopy, BoardEdge, Location>;

/// The elements of an item, rising; none for the board's edge and places. A net is its copper and its plated holes.
[[nodiscard]] std::vector<BoardElement> elementsOf(const BoardIndex& index, const MeasureItem& item);

/// The net of an element; none if it has none.
[[nodiscard]] NetId netOf(const BoardIndex& index, BoardElement at);
/// The layer of the board that an element lies on: where a flipped copy has put it.
[[nodiscard]] LayerId layerOf(const BoardIndex& index, BoardElement at);
/// What people call it: "net GND", "U1", "pin U1.3", "element 12 (TOP)", "the board's edge", "the location".
[[nodiscard]] std::string nameOf(const BoardIndex& index, const MeasureItem& item);
/// That a name stands for several components, or a pin for several pads, and where they are; empty if it does not.
[[nodiscard]] std::string noteOnName(const BoardIndex& index, const MeasureItem& item);
/// What an element is, without its net: "pad U1.7", "track", "via", "body of U1", "line" (of a drawing).
[[nodiscard]] std::string kindOf(const BoardIndex& index, BoardElement at);

/// How far the faces of two layers of the board that face each other are apart, in nm; 0 where their heights meet.
/// Nothing if one is none or is not in the stackup.
[[nodiscard]] std::optional<double> heightBetween(const Document& board, LayerId a, LayerId b);

/// The board's edge with its cut-outs: a figure per contour; none without a profile.
[[nodiscard]] FigureTable boardEdgeOf(const Document& board);

/// The point of the board's edge nearest to a location, if one is within `reach`, nm.
[[nodiscard]] std::optional<PointD> nearestOnEdge(const FigureTable& boardEdge, PointD location, double reach);

/// One connected piece of an item: an upright prism over a figure.
struct Piece {
    BoardElement at;  ///< element none: of the board's edge or a location
    LayerId layer;    ///< of the board, where a flipped copy has put it; none: of no layer
    LayerId top;      ///< holes: the layers they join or pass; others: their own
    LayerId bottom;
    bool hasHeights = false;  ///< drawings and the like are not in the stackup
    ZRange z;
    std::optional<bool> isMirrored;  ///< isMirroredInCopy; none: of both sides (other holes, locations, drawings)

    /// Lie both on one layer at least? What is on no layer lies on all. A layer and its mirror image are two.
    [[nodiscard]] bool sharesLayerWith(const Piece& other) const {
        const bool isOneSide = !isMirrored || !other.isMirrored || *isMirrored == *other.isMirrored;
        return !layer.isValid() || !other.layer.isValid() || (isOneSide && top <= other.bottom && other.top <= bottom);
    }
};

/// An item laid on the board: row n of `figures` is what piece n covers.
struct Pieces {
    FigureTable figures;
    std::vector<Piece> pieces;
    std::vector<BoardElement> elements;  ///< of the item, rising
    std::vector<BoardElement> empty;     ///< elements that cover nothing: tracks without width
};
[[nodiscard]] Pieces piecesOf(const BoardIndex& index, const MeasureItem& item);
[[nodiscard]] Pieces piecesOf(const BoardIndex& index, std::span<const BoardElement> elements);
/// Of a net, tracks that holes sever in their parts (SeveringHoles).
[[nodiscard]] Pieces connectedPiecesOf(const BoardIndex& index, NetOfCopy net);

}  // namespace model
