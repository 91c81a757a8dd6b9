#include "model/formats/ipc2581/shapes/hatches.h"

#include <cmath>

#include "model/formats/ipc2581/shapes/turn.h"
#include "model/geometry/boolean.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::ipc2581 {

namespace {

/// More lines than a hatch of 1 mm pitch needs on the largest panel.
constexpr double kMostLines = 2000.0;

bool addLines(PolygonSet& set, const Box& box, const HatchLines& lines, double width) {
    const SineCosine direction = sineCosineOf(lines.ccwDeg);
    const double sine = direction.sine;
    const double cosine = direction.cosine;
    const PointD middle = base::toDouble(box.middle());
    const double reach = std::hypot(static_cast<double>(box.width()), static_cast<double>(box.height())) / 2 + width;
    const double across = cosine * middle.y - sine * middle.x;  // of the middle, from the line through the origin
    const double first = std::ceil((across - reach) / lines.pitch);
    const double last = std::floor((across + reach) / lines.pitch);
    if (!(last - first <= kMostLines)) {
        return false;
    }
    for (double i = first; i <= last; i += 1.0) {
        const double offset = i * lines.pitch - across;
        const PointD on = {middle.x - sine * offset, middle.y + cosine * offset};
        const auto corner = [&](double along, double aside) {
            return rounded({on.x + cosine * along - sine * aside, on.y + sine * along + cosine * aside});
        };
        set.beginPolygon();
        set.addLoop(std::array<Point, 4>{corner(-reach, -width / 2), corner(reach, -width / 2),
                                         corner(reach, width / 2), corner(-reach, width / 2)});
    }
    return true;
}

}  // namespace

Hatch hatchOf(const ShapeSketch& area, const HatchStyle& style) {
    PolygonSet lines;
    const Box box = boxOf(area);
    bool isDrawn = style.width > 0 && !box.isEmpty();
    bool hasLines = false;
    for (const HatchLines& set : style.lines) {
        if (set.pitch > 0 && isDrawn) {
            isDrawn = addLines(lines, box, set, style.width);
            hasLines = true;
        }
    }
    if (!isDrawn || !hasLines) {
        return {area, "a hatch without a width or pitch that can be drawn is filled"};
    }
    return {sketchOf(intersect(polygonsOf(area), lines)), {}};
}

}  // namespace model::ipc2581
