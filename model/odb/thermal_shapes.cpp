// Thermals and other symbols that are cut by polygon booleans.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/geometry/boolean.h"
#include "model/odb/region.h"
#include "model/odb/symbol_shapes.h"

namespace model::odb {

namespace {

/// A point at distance `along` from the centre in direction `angle` (rad), `aside` to the left of that direction.
PointD polar(double angle, double along, double aside = 0.0) {
    return {along * std::cos(angle) - aside * std::sin(angle), along * std::sin(angle) + aside * std::cos(angle)};
}

double radiansOf(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

/// Directions of the gaps of a thermal: `first` degrees, then evenly all around.
std::vector<double> gapAngles(double first, double count) {
    const int gaps = std::clamp(static_cast<int>(std::lround(count)), 0, 360);
    std::vector<double> angles;
    for (int i = 0; i < gaps; ++i) {
        angles.push_back(radiansOf(first + 360.0 * i / gaps));
    }
    return angles;
}

/// Strips of width `gap` from the centre outwards, in the directions of the gaps.
PolygonSet gapStrips(const std::vector<double>& angles, double gap, double reach) {
    PolygonSet strips;
    for (const double angle : angles) {
        const std::array<Point, 4> strip = {rounded(polar(angle, 0, -gap / 2)), rounded(polar(angle, reach, -gap / 2)),
                                            rounded(polar(angle, reach, gap / 2)), rounded(polar(angle, 0, gap / 2))};
        strips.beginPolygon();
        strips.addLoop(strip);
    }
    return strips;
}

SymbolShape cutByGaps(const ShapeSketch& ring, double first, double count, double gap, double reach) {
    return regionShape(sketchOf(subtract(polygonsOf(ring), gapStrips(gapAngles(first, count), gap, reach))));
}

/// Is something left between two gaps, on a circle of this radius, when each takes `aside` to either side?
bool leavesPieces(const std::vector<double>& gaps, double aside, double radius) {
    const double half = std::numbers::pi / static_cast<double>(std::max<std::size_t>(gaps.size(), 2));
    return !gaps.empty() && aside < radius * std::sin(half);
}

}  // namespace

/// ths: the ends of each piece are parallel to the gap beside it. Exact: four corners and two arcs per piece.
SymbolShape roundThermalSquareEnds(const SymbolValues& v) {
    const double outer = v[0] / 2;
    const double inner = v[1] / 2;
    const std::vector<double> gaps = gapAngles(v[2], v[3]);
    if (inner >= outer) {
        return regionShape({});  // all hole
    }
    if (!leavesPieces(gaps, v[4] / 2, inner)) {
        ShapeSketch ring;
        addDisc(ring, v[0], false);
        addDisc(ring, v[1], true);
        return cutByGaps(ring, v[2], v[3], v[4], outer * 2);
    }
    const auto onCircle = [&](double angle, double radius, double aside) {
        return rounded(polar(angle, std::sqrt(radius * radius - aside * aside), aside));
    };
    ShapeSketch sketch;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const double from = gaps[i];
        const double to = gaps[(i + 1) % gaps.size()];
        const std::array<PathNode, 4> piece = {{{onCircle(from, outer, v[4] / 2), {}, EdgeKind::ArcCounterClockwise},
                                                lineNode(onCircle(to, outer, -v[4] / 2)),
                                                {onCircle(to, inner, -v[4] / 2), {}, EdgeKind::ArcClockwise},
                                                lineNode(onCircle(from, inner, v[4] / 2))}};
        addPath(sketch, piece, false);
    }
    return regionShape(std::move(sketch));
}

/// thr: each piece is a stroke along the middle circle with round ends that touch the gap.
SymbolShape roundThermalRoundEnds(const SymbolValues& v) {
    const double line = (v[0] - v[1]) / 2;
    const double middle = (v[0] + v[1]) / 4;
    const std::vector<double> gaps = gapAngles(v[2], v[3]);
    const double aside = v[4] / 2 + line / 2;
    ShapeSketch sketch;
    if (!leavesPieces(gaps, aside, middle)) {
        return roundThermalSquareEnds(v);
    }
    const double shift = std::asin(aside / middle);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        const double from = gaps[i] + shift;
        const double to = gaps[i] + 2 * std::numbers::pi / static_cast<double>(gaps.size()) - shift;
        const std::array<PathNode, 4> piece = {
            {{rounded(polar(from, v[0] / 2)), {}, EdgeKind::ArcCounterClockwise},
             {rounded(polar(to, v[0] / 2)), rounded(polar(to, middle)), EdgeKind::ArcCounterClockwise},
             {rounded(polar(to, v[1] / 2)), {}, EdgeKind::ArcClockwise},
             {rounded(polar(from, v[1] / 2)), rounded(polar(from, middle)), EdgeKind::ArcCounterClockwise}}};
        addPath(sketch, piece, false);
    }
    return regionShape(std::move(sketch));
}

/// s_ths, with rounded corners when a radius follows: OS × IS, angle, gaps, gap width.
SymbolShape squareThermal(const SymbolValues& v) {
    return cutByGaps(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[5], v.corners), v[2], v[3], v[4], v[0]);
}

/// sr_ths: square outside, round inside.
SymbolShape squareRoundThermal(const SymbolValues& v) {
    if (v[1] >= v[0]) {
        return regionShape({});
    }
    ShapeSketch ring;
    addBox(ring, v[0], v[0], false);
    addDisc(ring, v[1], true);
    return cutByGaps(ring, v[2], v[3], v[4], v[0]);
}

/// rc_ths: W × H, angle, gaps, gap width, line width, then a radius.
SymbolShape rectangleThermal(const SymbolValues& v) {
    return cutByGaps(boxRing(v[0], v[1], v[5], v[6], v.corners), v[2], v[3], v[4], v[0] + v[1]);
}

/// o_ths: W × H, angle, gaps, gap width, line width.
SymbolShape ovalThermal(const SymbolValues& v) {
    ShapeSketch ring;
    addOval(ring, v[0], v[1], false);
    if (std::min(v[0], v[1]) > 2 * v[5]) {
        addOval(ring, v[0] - 2 * v[5], v[1] - 2 * v[5], true);
    }
    return cutByGaps(ring, v[2], v[3], v[4], v[0] + v[1]);
}

/// moire: ring width, ring gap, rings, then the cross: line width, length, angle. Rings are counted from the outside of
/// a disc in the middle.
SymbolShape moire(const SymbolValues& v) {
    PolygonSet all;
    const int rings = std::clamp(static_cast<int>(std::lround(v[2])), 0, 100);
    for (int i = 0; i < rings; ++i) {
        const double inner = 2 * (v[0] + v[1]) * i + v[1];
        ShapeSketch ring;
        addDisc(ring, inner + 2 * v[0], false);
        if (inner > 0) {
            addDisc(ring, inner, true);
        }
        all.append(polygonsOf(ring));
    }
    const double half = v[4] / 2;
    for (int i = 0; i < 2; ++i) {
        const double angle = radiansOf(v[5] + 90.0 * i);
        const std::array<Point, 4> bar = {rounded(polar(angle, -half, -v[3] / 2)),
                                          rounded(polar(angle, half, -v[3] / 2)), rounded(polar(angle, half, v[3] / 2)),
                                          rounded(polar(angle, -half, v[3] / 2))};
        all.beginPolygon();
        all.addLoop(bar);
    }
    return regionShape(sketchOf(unite(all)));
}

}  // namespace model::odb
