#pragma once

#include "model/geometry/discretise.h"
#include "model/geometry/shapes.h"

namespace model {

/// Chords within 0.5 µm for pens and paths alike, so outlines are exact within 1 µm.
inline constexpr Discretisation kFinestSweep{Discretisation::kMinChordNm, false};

/// What a pen covers along one edge, `from.point` to `end`, without rotating: the Minkowski sum of pen and path.
[[nodiscard]] PolygonSet sweep(const PolygonSet& pen, const PathNode& from, Point end);

struct SweptTrack {
    PolygonSet cover;
    double chordNm = 0.0;  ///< tolerance of the chords; 0 if the pen is too intricate for its path to be drawn at all
};

/// The same for a pen with arcs (`finest` is it with the chords of kFinestSweep): where pen and path have so many sides
/// that the work would take longer than about a second, chords get coarser, up to 50 µm.
[[nodiscard]] SweptTrack sweep(const ShapeSketch& pen, const PolygonSet& finest, const PathNode& from, Point end);

}  // namespace model
