#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/formats/odb/features/features.h"
#include "model/geometry/shapes.h"

namespace model::odb {

/// What a symbol draws, centred where the pad is.
struct SymbolShape {
    enum class Kind {
        Nothing,  ///< `null`, or a symbol that `problem` explains
        Round,    ///< disc of diameter `width`
        Ring,     ///< ring, outer diameter `width`, inner `height`
        Oval,     ///< stadium `width` × `height`
        Region    ///< anything else
    };
    Kind kind = Kind::Nothing;
    Nm width = 0;
    Nm height = 0;
    ShapeSketch region;
    bool isSquarePen = false;  ///< an axis-parallel square, which strokes can be drawn with as it is
    std::string problem;       ///< for the diagnostics; empty if the symbol is drawn as it is
};

/// A shape without outer sizes in its name (user symbols, moire), resized: the outlines of its islands move outwards by
/// half of `resize`, corners stay sharp, holes stay as they are.
[[nodiscard]] SymbolShape resized(const SymbolShape& shape, Nm resize);

/// The shape of a standard symbol. Nothing when the name does not match the grammar completely (odb-notes, Features):
/// then it is a user symbol. A resize is added to the values that are outer sizes; all others (holes, line widths,
/// radii, gaps) stay as the name says. Sizes that are negative or exceed half a metre draw nothing (odb-notes,
/// Features), except that a ring without room for its hole is a disc.
[[nodiscard]] std::optional<SymbolShape> standardSymbol(const SymbolRef& symbol);

}  // namespace model::odb
