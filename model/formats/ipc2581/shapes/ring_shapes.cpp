#include "model/formats/ipc2581/shapes/ring_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/formats/ipc2581/shapes/turn.h"
#include "model/geometry/boolean.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::ipc2581 {

namespace {

/// A point `along` from the centre in this direction, `aside` to its left.
PointD polar(double degrees, double along, double aside = 0.0) {
    const auto [sine, cosine] = sineCosineOf(degrees);
    return {along * cosine - aside * sine, along * sine + aside * cosine};
}

/// A strip that leaves the centre.
void addStrip(PolygonSet& set, double degrees, double width, double reach) {
    set.beginPolygon();
    set.addLoop(std::array<Point, 4>{rounded(polar(degrees, 0, -width / 2)), rounded(polar(degrees, reach, -width / 2)),
                                     rounded(polar(degrees, reach, width / 2)), rounded(polar(degrees, 0, width / 2))});
}

/// Four corners and two arcs per piece; the ends are parallel to the cut beside them.
ShapeSketch roundPieces(const ThermalSizes& sizes) {
    const double aside = sizes.spokeWidth / 2;
    const double step = 360.0 / sizes.spokes;
    const auto corner = [&](double degrees, double radius, double side) {
        return rounded(polar(degrees, std::sqrt(radius * radius - aside * aside), side));
    };
    ShapeSketch sketch;
    for (int i = 0; i < sizes.spokes; ++i) {
        const double from = sizes.startDeg + i * step;
        const double to = from + step;
        const std::array<PathNode, 4> piece = {
            {{corner(from, sizes.outer / 2, aside), {}, EdgeKind::ArcCounterClockwise},
             {corner(to, sizes.outer / 2, -aside), {}, EdgeKind::Line},
             {corner(to, sizes.inner / 2, -aside), {}, EdgeKind::ArcClockwise},
             {corner(from, sizes.inner / 2, aside), {}, EdgeKind::Line}}};
        addPath(sketch, piece, false);
    }
    return sketch;
}

}  // namespace

void addRingSide(ShapeSketch& sketch, std::string_view form, double diameter, bool isHole) {
    if (form == "SQUARE") {
        return addBox(sketch, diameter, diameter, isHole);
    }
    if (form == "OCTAGON") {
        return addCornerBox(sketch, diameter, diameter, diameter * (1.0 - std::numbers::sqrt2 / 2.0), kAllCorners,
                            CornerStyle::Chamfered, isHole);
    }
    if (form == "HEXAGON") {
        std::array<PointD, 6> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] = polar(60.0 * static_cast<double>(i), diameter / 2);
        }
        return addLoop(sketch, corners, isHole);
    }
    addDisc(sketch, diameter, isHole);
}

ShapeSketch thermal(std::string_view form, const ThermalSizes& sizes) {
    ShapeSketch ring;
    if (sizes.inner >= sizes.outer) {
        return ring;
    }
    addRingSide(ring, form, sizes.outer, false);
    if (sizes.inner > 0) {
        addRingSide(ring, form, sizes.inner, true);
    }
    if (sizes.spokes == 0 || sizes.spokeWidth <= 0) {
        return ring;
    }
    const double half = std::numbers::pi / std::max(sizes.spokes, 2);
    const bool isRound = form != "SQUARE" && form != "HEXAGON" && form != "OCTAGON";
    if (isRound && sizes.spokeWidth / 2 < sizes.inner / 2 * std::sin(half)) {
        return roundPieces(sizes);
    }
    PolygonSet cuts;
    for (int i = 0; i < sizes.spokes; ++i) {
        addStrip(cuts, sizes.startDeg + 360.0 * i / sizes.spokes, sizes.spokeWidth, sizes.outer);
    }
    return sketchOf(subtract(polygonsOf(ring), cuts));
}

ShapeSketch moire(const MoireSizes& sizes) {
    ShapeSketch parts;
    double outer = sizes.diameter;
    for (int ring = 0; ring < sizes.rings && outer > 0; ++ring) {
        addDisc(parts, outer, false);
        const double inner = outer - 2 * sizes.ringWidth;
        if (inner > 0) {
            addDisc(parts, inner, true);
        }
        outer = inner - 2 * sizes.ringGap;
    }
    for (const double degrees : {sizes.lineDeg, sizes.lineDeg + 90.0}) {
        const PointD end = polar(degrees, sizes.lineLength / 2);
        const PointD side = polar(degrees, 0, sizes.lineWidth / 2);
        if (sizes.lineWidth > 0 && sizes.lineLength > 0) {
            addLoop(parts,
                    std::array<PointD, 4>{{{-end.x - side.x, -end.y - side.y},
                                           {end.x - side.x, end.y - side.y},
                                           {end.x + side.x, end.y + side.y},
                                           {-end.x + side.x, -end.y + side.y}}},
                    false);
        }
    }
    return sketchOf(unite(polygonsOf(parts)));
}

}  // namespace model::ipc2581
