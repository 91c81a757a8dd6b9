#pragma once

#include <optional>

#include "model/board/copies.h"
#include "model/section/section_material.h"

namespace model {

/// A trapezoid of a cut with a level lower and upper edge: a rectangle, but for what leans (walls of laser vias,
/// shoulders of solder mask).
struct SectionPiece {
    LayerId layer;    ///< of the board, where a flipped copy has put it
    BoardElement at;  ///< element none: of several (see merged), or not drawn (see makeSection)
    double from = 0;  ///< of the lower edge, along the line from its start, over all corners, nm
    double to = 0;
    Nm bottom = 0;  ///< equal to `top` where the layer has no thickness
    Nm top = 0;
    double leanFrom = 0.0;  ///< by so much the upper edge begins and ends farther along than the lower one
    double leanTo = 0.0;
    SectionMaterial material = SectionMaterial::Other;
    std::optional<std::size_t> stackupRow = {};  ///< of Stackup::rows; of dielectrics that it has
    bool isMirrored = false;                     ///< isMirroredInCopy: on the other side than its layer

    [[nodiscard]] bool leans() const { return leanFrom != 0.0 || leanTo != 0.0; }
    [[nodiscard]] double upperFrom() const { return from + leanFrom; }
    [[nodiscard]] double upperTo() const { return to + leanTo; }
    [[nodiscard]] double least() const { return leanFrom < 0.0 ? upperFrom() : from; }
    [[nodiscard]] double most() const { return leanTo > 0.0 ? upperTo() : to; }
};

/// The dielectric that a piece is of; null: it is of none, or the stackup has no row for it. Its thickness is that
/// between two layers of copper: the piece is higher where it fills the space beside copper too.
[[nodiscard]] inline const StackupRow* stackupRowOf(const Document& board, const SectionPiece& piece) {
    return piece.stackupRow ? &board.stackup.rows[*piece.stackupRow] : nullptr;
}

}  // namespace model
