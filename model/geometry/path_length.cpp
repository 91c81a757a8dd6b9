#include "model/geometry/path_length.h"

#include <cmath>

#include "model/geometry/discretise.h"

namespace model {

double pathLength(const PathNode& from, Point to) {
    const PointD a = base::toDouble(from.point);
    const PointD b = base::toDouble(to);
    if (from.edge == EdgeKind::Line) {
        return std::hypot(b.x - a.x, b.y - a.y);
    }
    const PointD c = base::toDouble(from.centre);
    const double radius = (std::hypot(a.x - c.x, a.y - c.y) + std::hypot(b.x - c.x, b.y - c.y)) / 2.0;
    return radius * std::abs(sweepOf(from, to));
}

}  // namespace model
