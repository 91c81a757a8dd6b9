#include "model/solids/shells/line_shell.h"

#include <vector>

#include "model/geometry/outlines.h"

namespace model {

namespace {

EdgeLoops squareTrack(const LineGeometry& line) {
    // The doubled grid holds the corners of pens of odd width exactly.
    std::vector<Point> corners;
    for (const Point end : {line.a, line.b}) {
        for (const int side : {-1, 1}) {
            corners.push_back({2 * end.x + side * line.width, 2 * end.y - line.width});
            corners.push_back({2 * end.x + side * line.width, 2 * end.y + line.width});
        }
    }
    const std::vector<Point> hull = convexHull(std::move(corners));
    EdgeLoops loops;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point next = hull[(i + 1) % hull.size()];
        loops.addLine({hull[i].x / 2.0, hull[i].y / 2.0}, {next.x / 2.0, next.y / 2.0});
    }
    loops.endLoop();
    return loops;
}

}  // namespace

EdgeLoops lineOutline(const LineGeometry& line, bool hasSquarePen) {
    if (line.width <= 0 || line.innerWidth >= line.width) {
        return {};
    }
    if (hasSquarePen) {
        return squareTrack(line);
    }
    EdgeLoops loops;
    loops.addCapsule(toDouble(line.a), toDouble(line.b), line.width / 2.0);
    if (line.innerWidth > 0) {
        loops.addCapsule(toDouble(line.a), toDouble(line.b), line.innerWidth / 2.0);
    }
    return loops;
}

}  // namespace model
