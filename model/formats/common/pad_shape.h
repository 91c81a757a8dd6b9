#pragma once

#include <string>

#include "model/geometry/shapes.h"

namespace model::formats {

/// What a pad draws, centred where it lies, or the pen of a track.
struct PadShape {
    enum class Kind {
        Nothing,  ///< nothing at all, or a shape that `problem` explains
        Round,    ///< disc of diameter `width`
        Ring,     ///< ring, outer diameter `width`, inner `height`
        Oval,     ///< stadium `width` × `height`
        Region    ///< anything else
    };
    Kind kind = Kind::Nothing;
    Nm width = 0;
    Nm height = 0;
    ShapeSketch region;
    bool isSquarePen = false;  ///< an axis-parallel square, which tracks can be drawn with as it is
    std::string problem;       ///< for the diagnostics; empty if the shape is drawn as it is
};

/// The outline of any of them.
[[nodiscard]] ShapeSketch outlineOf(const PadShape& shape);

}  // namespace model::formats
