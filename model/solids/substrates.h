#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// A part of the substrate that the same holes pass all the way and that has one outline.
struct SubstratePart {
    Nm bottom = 0;
    Nm top = 0;
    std::vector<ShapeId> outlines;             ///< it is within all of them, each once; none: nowhere
    std::vector<std::uint32_t> outlineGroups;  ///< Layer::outlineGroup of what bounds it, but for 0; rising
    std::vector<LayerId> holes;                ///< drill and rout layers, rising

    [[nodiscard]] bool isLike(const SubstratePart& other) const {
        return outlineGroups == other.outlineGroups && holes == other.holes;
    }
};

/// The substrate from the top. It reaches from the upper face of the lowest to the lower face of the highest copper
/// layer (of a board with one copper layer: the board's thickness below it, or above where it is the bottom one) and is
/// cut where a hole layer ends and where a layer with an outline of its own begins or ends; parts that are alike are
/// one. On a board with such layers (rigid-flex) every dielectric is a part, so that exploded each lies between its
/// copper layers. A dielectric that is no layer of the job is where the copper above and below it is, and what lies
/// beside copper is where the dielectrics above and below that are: outermost copper of a zone has none beside it.
/// Heights and holes depend on the layers only, not on what is on them, so that all steps of a panel have the same
/// parts, each with its own outlines.
[[nodiscard]] std::vector<SubstratePart> substratesOf(const Document& document);

}  // namespace model
