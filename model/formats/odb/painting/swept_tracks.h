#pragma once

#include <span>

#include "model/formats/odb/symbols/standard_symbols.h"
#include "model/geometry/discretise.h"

namespace model::odb {

/// Chords within 0.5 µm for pens and ways alike, so outlines are exact within 1 µm.
inline constexpr Discretisation kFinestSweep{Discretisation::kMinChordNm, false};

/// What a symbol draws, as polygons: the pen of a stroke.
[[nodiscard]] PolygonSet penOf(const SymbolShape& shape, const Discretisation& chords = kFinestSweep);

/// What a pen covers on its way along one edge, `from.point` to `end`, without turning: the Minkowski sum of pen and
/// path.
[[nodiscard]] PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end);

struct SweptTrack {
    PolygonSet cover;
    double chordNm = 0.0;  ///< tolerance of the chords; 0 if the pen is too intricate for its way to be drawn at all
};

/// The same for a symbol (`finestPen` is its penOf): where pen and way have so many sides that the work would take
/// longer than about a second, chords get coarser, up to 50 µm.
[[nodiscard]] SweptTrack sweep(const SymbolShape& shape, const PolygonSet& finestPen, const PathNode& from, Point end);

}  // namespace model::odb
