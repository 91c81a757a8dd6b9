#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/formats/common/pad_shape.h"
#include "model/geometry/loops/edge_loops.h"

namespace model::gerber {

/// One primitive of an aperture macro, laid where it belongs, in nanometres.
struct Primitive {
    bool isDark = true;             ///< exposure; a light one takes away what the macro drew before it
    std::vector<EdgeLoops> pieces;  ///< what it covers
    std::string problem;            ///< what is not drawn as it is written, for the diagnostics; empty if nothing
};

/// The values of a primitive behind its code, lengths in nanometres. Missing ones are 0.
using PrimitiveValues = std::span<const double>;

/// The primitive with this code, rotated about the macro's origin as its last value says. A size of 0 covers nothing,
/// which is as it should be; what covers nothing for another reason has a `problem`, codes that no specification ever
/// had among them.
[[nodiscard]] Primitive primitive(int code, PrimitiveValues values);

/// How many corners a regular polygon is drawn with, and why they are not as many as the file says, or more than it
/// may say.
struct CornerCount {
    int count = 0;  ///< 0: it cannot be drawn
    std::string problem;
};
[[nodiscard]] CornerCount cornersOfPolygon(double number);

/// What the primitives of a macro leave, lines and arcs exact.
[[nodiscard]] formats::PadShape combined(std::vector<Primitive> primitives);

}  // namespace model::gerber
