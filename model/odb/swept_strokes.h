#pragma once

#include <span>

#include "model/geometry/discretise.h"
#include "model/odb/standard_symbols.h"

namespace model::odb {

/// What a symbol draws, as polygons no further than 0.5 µm from it: the pen of a stroke.
[[nodiscard]] PolygonSet penOf(const SymbolShape& shape);

/// What a pen covers on its way along one edge, `from.point` to `end`, without turning: the Minkowski sum of pen and
/// path. Arcs are taken as chords within 0.5 µm, so together with the pen the outline is exact within 1 µm.
[[nodiscard]] PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end);

}  // namespace model::odb
