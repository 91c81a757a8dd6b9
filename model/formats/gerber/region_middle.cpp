#include "model/formats/gerber/region_middle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::gerber {

namespace {

constexpr std::size_t kMostCorners = 500;  ///< the search takes the square of it
/// A rectangle counts when it is this much smaller than the box: rounding makes some a little smaller.
constexpr double kSmaller = 0.999;

struct Rectangle {
    double area = std::numeric_limits<double>::max();
    PointD middle;
};

/// Around the points, one side along `a` to `b`.
Rectangle rectangleAlong(std::span<const Point> points, PointD a, PointD b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const PointD along{(b.x - a.x) / length, (b.y - a.y) / length};
    PointD low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    PointD high{-low.x, -low.y};
    for (const Point point : points) {
        const PointD p{point.x - a.x, point.y - a.y};
        const PointD seen{p.x * along.x + p.y * along.y, p.y * along.x - p.x * along.y};
        low = {std::min(low.x, seen.x), std::min(low.y, seen.y)};
        high = {std::max(high.x, seen.x), std::max(high.y, seen.y)};
    }
    const PointD middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    return {(high.x - low.x) * (high.y - low.y),
            {a.x + middle.x * along.x - middle.y * along.y, a.y + middle.x * along.y + middle.y * along.x}};
}

}  // namespace

Point middleOfPad(const ShapeSketch& region) {
    const Box box = boxOf(region);
    if (box.isEmpty()) {
        return {};
    }
    const std::vector<Point> hull = convexHull(polygonsOf(region).points);
    Rectangle best{static_cast<double>(box.width()) * static_cast<double>(box.height()) * kSmaller,
                   base::toDouble(box.middle())};
    for (std::size_t i = 0; hull.size() >= 3 && hull.size() <= kMostCorners && i < hull.size(); ++i) {
        const Rectangle one =
            rectangleAlong(hull, base::toDouble(hull[i]), base::toDouble(hull[(i + 1) % hull.size()]));
        best = one.area < best.area ? one : best;
    }
    return rounded(best.middle);
}

}  // namespace model::gerber
