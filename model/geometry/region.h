#pragma once

#include "model/geometry/discretise.h"
#include "model/geometry/shapes.h"

namespace model {

/// Chord tolerance wherever a region has to be computed by polygon booleans: 1 µm.
inline constexpr Discretisation kBooleanChords{1000.0, false};

/// What the contours cover, in whatever order they were sketched.
[[nodiscard]] PolygonSet polygonsOf(const ShapeSketch& sketch, const Discretisation& how = kBooleanChords);
/// A shape of a table with `placement` applied to its nodes; arcs stay arcs.
[[nodiscard]] ShapeSketch sketchOf(const ShapeTable& table, ShapeId shape, const Placement& placement = {});

}  // namespace model
