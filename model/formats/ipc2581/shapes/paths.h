#pragma once

#include <vector>

#include "model/formats/ipc2581/shapes/turn.h"

/// Polygons, polylines and cutouts: points and the edges between them.
namespace model::ipc2581 {

/// A point and the edge that leads to it.
struct PathStep {
    PointD point;
    PointD centre;  ///< of an arc
    EdgeKind edge = EdgeKind::Line;
};

/// Nanometres in the system of what holds it. The first step has no edge.
using Path = std::vector<PathStep>;

/// One edge of a path, laid on the board.
struct LaidEdge {
    PointD a;
    PointD b;
    PointD centre;
    EdgeKind edge = EdgeKind::Line;
    bool isFullCircle = false;
};

/// The edge from step `to` - 1 to step `to`. An arc whose ends coincide is a full circle if it is all there is of the
/// path, else nothing: a straight edge without length.
[[nodiscard]] LaidEdge laidEdge(const Path& path, std::size_t to, const Turn& turn);

/// The same edge the other way round in a mirror.
[[nodiscard]] EdgeKind mirrored(EdgeKind edge, bool isMirrored);

}  // namespace model::ipc2581
