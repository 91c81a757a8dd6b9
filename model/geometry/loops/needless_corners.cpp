#include "model/geometry/loops/needless_corners.h"

#include <algorithm>

#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// More corners than this are not replaced by one line, so that the cost stays linear.
constexpr std::size_t kMostCorners = 32;

double distanceFrom(PointD p, PointD a, PointD b) {
    const PointD along = minus(b, a);
    const double squared = dot(along, along);
    const double at = squared > 0 ? std::clamp(dot(minus(p, a), along) / squared, 0.0, 1.0) : 0.0;
    return distance(p, {a.x + at * along.x, a.y + at * along.y});
}

/// Does one line from `first` replace `count` edges?
bool isStraight(std::span<const Edge> loop, std::size_t first, std::size_t count, double tolerance) {
    const PointD a = loop[first].a;
    const PointD b = loop[first + count - 1].b;
    return std::ranges::all_of(loop.subspan(first + 1, count - 1),
                               [&](const Edge& edge) { return distanceFrom(edge.a, a, b) <= tolerance; });
}

void addLoop(EdgeLoops& kept, std::span<const Edge> loop, double tolerance) {
    for (std::size_t i = 0; i < loop.size();) {
        if (loop[i].isArc()) {
            kept.edges.push_back(loop[i++]);
            continue;
        }
        std::size_t count = 1;
        while (count < kMostCorners && i + count < loop.size() && !loop[i + count].isArc() &&
               isStraight(loop, i, count + 1, tolerance)) {
            ++count;
        }
        kept.addLine(loop[i].a, loop[i + count - 1].b);
        i += count;
    }
    kept.endLoop();
}

}  // namespace

EdgeLoops withoutNeedlessCorners(const EdgeLoops& region, double tolerance) {
    if (!region.curves.empty()) {
        return region;
    }
    EdgeLoops kept;
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        addLoop(kept, region.loop(i), tolerance);
    }
    const bool isLike = kept.loopCount() == region.loopCount() && kept.edges.size() < region.edges.size();
    return isLike && !findFault(kept) ? kept : region;
}

}  // namespace model
