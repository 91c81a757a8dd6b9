#include "model/formats/ipc2581/shapes/paths.h"

#include "model/geometry/edges.h"

namespace model::ipc2581 {

EdgeKind mirrored(EdgeKind edge, bool isMirrored) {
    return isMirrored ? reversed(edge) : edge;
}

LaidEdge laidEdge(const Path& path, std::size_t to, const Turn& turn) {
    const PathStep& from = path[to - 1];
    const PathStep& step = path[to];
    const bool closes = from.point == step.point;
    const bool isDot = isArc(step.edge) && (step.centre == from.point || (closes && path.size() > 2));
    LaidEdge edge{turn.apply(from.point), turn.apply(step.point), {}, EdgeKind::Line, false};
    if (isArc(step.edge) && !isDot) {
        edge.centre = turn.apply(step.centre);
        edge.edge = mirrored(step.edge, turn.isMirrored);
        edge.isFullCircle = closes;
    }
    return edge;
}

}  // namespace model::ipc2581
