#pragma once

#include <array>
#include <string>

#include "model/geometry/shapes.h"

namespace model::ipc2581 {

/// Parallel lines; a pitch of 0: there are none.
struct HatchLines {
    double ccwDeg = 0.0;
    double pitch = 0.0;
};

struct HatchStyle {
    std::array<HatchLines, 2> lines;
    double width = 0.0;
};

struct Hatch {
    ShapeSketch shape;
    std::string problem;  ///< why all of the area is filled instead; else empty
};

/// What the lines cover of the area: polygons no further than 1 µm from its arcs. Lines of a set pass at multiples of
/// its pitch from the origin.
[[nodiscard]] Hatch hatchOf(const ShapeSketch& area, const HatchStyle& style);

}  // namespace model::ipc2581
