#pragma once

#include "model/geometry/shapes.h"

namespace model {

/// The same contours with every hole behind the island that contains it (the smallest one, if islands lie in holes of
/// others). Jobs need not write them in that order: Altium lists all islands of a text first and then all holes. A hole
/// that lies in no island keeps its place.
[[nodiscard]] ShapeSketch nestHoles(ShapeSketch sketch);

}  // namespace model
