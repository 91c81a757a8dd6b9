#pragma once

#include "model/geometry/discretise.h"
#include "model/shapes.h"

namespace model::odb {

/// Chord tolerance wherever a region has to be computed by polygon booleans: 1 µm.
inline constexpr Discretisation kBooleanChords{1000.0, false};

[[nodiscard]] PolygonSet polygonsOf(const ShapeSketch& sketch, const Discretisation& how = kBooleanChords);
/// Straight-edged region; loops that are too small to be one are left out.
[[nodiscard]] ShapeSketch sketchOf(const PolygonSet& polygons);
/// A shape of a table with `placement` applied to its nodes; arcs stay arcs.
[[nodiscard]] ShapeSketch sketchOf(const ShapeTable& table, std::uint32_t shape, const Placement& placement);
[[nodiscard]] ShapeSketch placed(const ShapeSketch& sketch, const Placement& placement);
[[nodiscard]] PathNode placed(const PathNode& node, const Placement& placement);
[[nodiscard]] bool isIdentity(const Placement& placement);

}  // namespace model::odb
