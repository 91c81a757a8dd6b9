#pragma once

#include <span>
#include <vector>

#include "model/formats/common/pad_shape.h"
#include "model/geometry/loops/edge_loops.h"

namespace model::gerber {

/// One primitive of an aperture macro, laid where it belongs, in nanometres.
struct Primitive {
    bool isDark = true;             ///< exposure; a light one takes away what the macro drew before it
    std::vector<EdgeLoops> pieces;  ///< what it covers
};

/// The values of a primitive behind its code, lengths in nanometres. Missing ones are 0.
using PrimitiveValues = std::span<const double>;

/// The primitive with this code, rotated about the macro's origin as its last value says. Nothing covered when a size
/// is 0 or less. `isKnown` is false for codes that no specification ever had.
[[nodiscard]] Primitive primitive(int code, PrimitiveValues values, bool& isKnown);

/// What the primitives of a macro leave, lines and arcs exact.
[[nodiscard]] formats::PadShape combined(std::vector<Primitive> primitives);

/// A sketch as regions with exact edges: each island with the holes behind it.
[[nodiscard]] std::vector<EdgeLoops> regionsOf(const ShapeSketch& sketch);

}  // namespace model::gerber
