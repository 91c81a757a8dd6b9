#pragma once

#include <string>

#include "model/formats/common/pad_shape.h"
#include "model/geometry/shapes.h"

namespace model::kicad {

/// A pad as it lies in its own frame, y up, lengths in nanometres.
struct PadForm {
    enum class Kind { Circle, Oval, Rectangle, RoundRectangle, Trapezoid, Custom };
    Kind kind = Kind::Circle;
    PointD size;
    double radiusRatio = 0.0;   ///< RoundRectangle: of the smaller side
    double chamferRatio = 0.0;  ///< RoundRectangle: of the smaller side
    unsigned chamfers = 0;      ///< corners as in outlines.h
    PointD delta;               ///< Trapezoid
    ShapeSketch custom;         ///< Custom: all of it
    std::string customName;     ///< Custom: tells it from others
};

/// The shape of a pad, larger on every side by a margin, as KiCad makes openings: rounded rectangles keep the ratio of
/// their radius, rectangles get round corners, all else is followed at that distance. Margins of both axes differ for
/// paste only; shapes that are followed take the first one.
[[nodiscard]] formats::PadShape shapeOf(const PadForm& form, PointD margin);
/// One name for equal shapes.
[[nodiscard]] std::string nameOf(const PadForm& form, PointD margin);

}  // namespace model::kicad
