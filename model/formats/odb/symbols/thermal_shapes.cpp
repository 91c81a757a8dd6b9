// Thermals: rings with gaps.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/formats/odb/symbols/symbol_shapes.h"
#include "model/geometry/boolean.h"
#include "model/geometry/region.h"

namespace model::odb {

namespace {

double radiansOf(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

/// Directions of the gaps of a thermal in radians: `first` degrees, then evenly all around.
std::vector<double> gapAngles(double first, double count) {
    const long gaps = std::lround(count);
    std::vector<double> angles;
    for (long i = 0; i < gaps; ++i) {
        angles.push_back(radiansOf(first + 360.0 * static_cast<double>(i) / static_cast<double>(gaps)));
    }
    return angles;
}

/// A gap cuts a strip from its origin outwards.
struct Gap {
    PointD origin;
    double angle = 0.0;
};

bool isDiagonal(double angle) {
    return std::abs(std::sin(2 * angle)) > 0.5;
}

/// The gaps of a ring `width` × `height`: they start in the centre, diagonal ones of a longish ring so far along its
/// longer side that they leave through its corners.
std::vector<Gap> gapsOf(double first, double count, double width, double height) {
    std::vector<Gap> gaps;
    for (const double angle : gapAngles(first, count)) {
        const double dx = isDiagonal(angle) ? std::copysign(std::max(width - height, 0.0) / 2, std::cos(angle)) : 0.0;
        const double dy = isDiagonal(angle) ? std::copysign(std::max(height - width, 0.0) / 2, std::sin(angle)) : 0.0;
        gaps.push_back({{dx, dy}, angle});
    }
    return gaps;
}

void addStrip(PolygonSet& strips, const Gap& gap, double width, double reach) {
    const auto corner = [&](double along, double aside) {
        const PointD p = polar(gap.angle, along, aside);
        return rounded({gap.origin.x + p.x, gap.origin.y + p.y});
    };
    strips.beginPolygon();
    strips.addLoop(std::array<Point, 4>{corner(0, -width / 2), corner(reach, -width / 2), corner(reach, width / 2),
                                        corner(0, width / 2)});
}

PadShape cutByGaps(const ShapeSketch& ring, const std::vector<Gap>& gaps, double width, double reach) {
    PolygonSet strips;
    for (const Gap& gap : gaps) {
        addStrip(strips, gap, width, reach);
    }
    return regionShape(sketchOf(subtract(polygonsOf(ring), strips)));
}

/// Gaps of a round or oval ring: all start in the centre.
std::vector<Gap> centralGaps(double first, double count) {
    return gapsOf(first, count, 0.0, 0.0);
}

/// What an open-cornered thermal loses: a diagonal gap takes the whole corner and the bars beside it up to where the
/// edges of the gap meet the inside of the ring; other gaps cut strips.
PadShape openCorners(const ShapeSketch& ring, const SymbolValues& v, double innerWidth, double innerHeight,
                     double width, double height) {
    PolygonSet cuts;
    const double back = v[4] / std::numbers::sqrt2;
    const double reach = width + height;
    for (const Gap& gap : gapsOf(v[2], v[3], width, height)) {
        if (!isDiagonal(gap.angle)) {
            addStrip(cuts, gap, v[4], reach);
            continue;
        }
        const double sx = std::copysign(1.0, std::cos(gap.angle));
        const double sy = std::copysign(1.0, std::sin(gap.angle));
        const PointD inner = {sx * (innerWidth / 2 - back), sy * (innerHeight / 2 - back)};
        cuts.beginPolygon();
        cuts.addLoop(std::array<Point, 4>{rounded(inner), rounded({sx * reach, inner.y}),
                                          rounded({sx * reach, sy * reach}), rounded({inner.x, sy * reach})});
    }
    return regionShape(sketchOf(subtract(polygonsOf(ring), cuts)));
}

/// Is a piece left between two gaps, on a circle of this radius, when each takes `aside` to either side?
bool leavesPieces(const std::vector<double>& gaps, double aside, double radius) {
    const double half = std::numbers::pi / static_cast<double>(std::max<std::size_t>(gaps.size(), 2));
    return !gaps.empty() && aside < radius * std::sin(half);
}

/// ths: the ends of each piece are parallel to the gap beside it. Exact: four corners and two arcs per piece.
PadShape roundThermalSquareEnds(const SymbolValues& v) {
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
        return cutByGaps(ring, centralGaps(v[2], v[3]), v[4], outer * 2);
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

/// thr: each piece is a track along the middle circle with round ends that touch the gap.
PadShape roundThermalRoundEnds(const SymbolValues& v) {
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
PadShape squareThermal(const SymbolValues& v) {
    return cutByGaps(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[5], v.corners), centralGaps(v[2], v[3]), v[4], v[0]);
}

/// sr_ths: square outside, round inside.
PadShape squareRoundThermal(const SymbolValues& v) {
    return cutByGaps(squareRoundRing(v[0], v[1]), centralGaps(v[2], v[3]), v[4], v[0]);
}

/// rc_ths: W × H, angle, gaps, gap width, line width, then a radius.
PadShape rectangleThermal(const SymbolValues& v) {
    return cutByGaps(boxRing(v[0], v[1], v[5], v[6], v.corners), gapsOf(v[2], v[3], v[0], v[1]), v[4], v[0] + v[1]);
}

/// s_tho, with rounded corners when a radius follows: OS × IS, angle, gaps, gap width.
PadShape squareThermalOpenCorners(const SymbolValues& v) {
    return openCorners(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[5], v.corners), v, v[1], v[1], v[0], v[0]);
}

/// rc_tho: W × H, angle, gaps, gap width, line width, then a radius.
PadShape rectangleThermalOpenCorners(const SymbolValues& v) {
    return openCorners(boxRing(v[0], v[1], v[5], v[6], v.corners), v, v[0] - 2 * v[5], v[1] - 2 * v[5], v[0], v[1]);
}

/// s_thr: OS × IS, and the gap width behind 45°, 4 gaps: four bars with round ends.
PadShape lineThermal(const SymbolValues& v) {
    const double line = (v[0] - v[1]) / 2;
    const double middle = (v[0] + v[1]) / 4;
    // A bar ends where the edge of the gap meets the inside of the ring, its end node half a line before.
    const double half = v[1] / 2 - v[2] / std::numbers::sqrt2 - line / 2;
    ShapeSketch sketch;
    if (half < 0) {
        return regionShape({});
    }
    for (const double sign : {1.0, -1.0}) {
        addCapsule(sketch, {-half, sign * middle}, {half, sign * middle}, line);
        addCapsule(sketch, {sign * middle, -half}, {sign * middle, half}, line);
    }
    return regionShape(std::move(sketch));
}

/// oblong_ths …xs: like o_ths, but a rectangle; …xr is o_ths.
PadShape oblongThermalStraight(const SymbolValues& v) {
    return cutByGaps(boxRing(v[0], v[1], v[5], 0.0, kAllCorners), gapsOf(v[2], v[3], v[0], v[1]), v[4], v[0] + v[1]);
}

/// o_ths: W × H, angle, gaps, gap width, line width.
PadShape ovalThermal(const SymbolValues& v) {
    return cutByGaps(ovalRing(v[0], v[1], v[5]), centralGaps(v[2], v[3]), v[4], v[0] + v[1]);
}

constexpr SymbolRule kRules[] = {
    {"thr#x#x@x@x#", roundThermalRoundEnds, 1, 0, 0b1000},
    {"ths#x#x@x@x#", roundThermalSquareEnds, 1, 0, 0b1000},
    {"s_ths#x#x@x@x#[xr#[x%]]", squareThermal, 1, 0, 0b1000},
    {"s_tho#x#x@x@x#[xr#[x%]]", squareThermalOpenCorners, 1, 0, 0b1000},
    {"s_thr#x#x45x4x#", lineThermal, 1},
    {"sr_ths#x#x@x@x#", squareRoundThermal, 1, 0, 0b1000},
    {"rc_ths#x#x@x@x#x#[xr#[x%]]", rectangleThermal, 2, 0, 0b1000},
    {"rc_tho#x#x@x@x#x#[xr#[x%]]", rectangleThermalOpenCorners, 2, 0, 0b1000},
    {"o_ths#x#x@x@x#x#", ovalThermal, 2, 0, 0b1000},
    {"oblong_ths#x#x@x@x#x#xr", ovalThermal, 2, 0, 0b1000},
    {"oblong_ths#x#x@x@x#x#xs", oblongThermalStraight, 2, 0, 0b1000},
};

}  // namespace

std::span<const SymbolRule> thermalRules() {
    return kRules;
}

}  // namespace model::odb
