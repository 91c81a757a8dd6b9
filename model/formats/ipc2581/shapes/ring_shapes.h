#pragma once

#include <string_view>

#include "model/geometry/shapes.h"

/// Primitives made of rings: donuts, thermals, moires. Lengths in nanometres.
namespace model::ipc2581 {

/// What bounds a ring on one side: "ROUND", "SQUARE", "HEXAGON" or "OCTAGON".
void addRingSide(ShapeSketch& sketch, std::string_view form, double diameter, bool isHole);

struct ThermalSizes {
    double outer = 0.0;
    double inner = 0.0;
    int spokes = 0;
    double spokeWidth = 0.0;  ///< of the cuts through the ring
    double startDeg = 0.0;    ///< where the first one is, counter-clockwise from the right
};
/// Round ones have exact arcs; cuts through others are computed (1 µm where they meet arcs).
[[nodiscard]] ShapeSketch thermal(std::string_view form, const ThermalSizes& sizes);

struct MoireSizes {
    double diameter = 0.0;  ///< of the outermost ring
    double ringWidth = 0.0;
    double ringGap = 0.0;
    int rings = 0;
    double lineWidth = 0.0;
    double lineLength = 0.0;
    double lineDeg = 0.0;
};
/// Rings from the outermost inwards and a cross over them, as polygons no further than 1 µm from their arcs.
[[nodiscard]] ShapeSketch moire(const MoireSizes& sizes);

}  // namespace model::ipc2581
