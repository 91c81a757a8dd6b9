// Symbols made for solder stencils (format 8). Their pictures have the point, notch or arc on the right, at +x. Which
// of two radii a corner gets goes by its angle: `ra` up to a right angle, `ro` above (odb-notes, Symbols).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/formats/odb/symbols/symbol_shapes.h"

namespace model::odb {

namespace {

/// The inner angle at a corner of a counter-clockwise outline, in radians up to 2π.
double innerAngle(PointD before, PointD corner, PointD after) {
    const double in = std::atan2(before.y - corner.y, before.x - corner.x);
    const double out = std::atan2(after.y - corner.y, after.x - corner.x);
    const double angle = in - out;
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

PadShape plate(std::span<const PointD> points, double acute, double obtuse) {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t count = points.size();
        const double angle = innerAngle(points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
        corners.push_back({points[i], angle < std::numbers::pi / 2 + 1e-9 ? acute : obtuse});
    }
    return drawn([&](ShapeSketch& sketch) { addRoundedLoop(sketch, corners); });
}

/// W × H, cut, then ra and ro: a box whose right end runs to a point (hplate), or has a notch (rhplate), the cut is its
/// depth.
PadShape homePlate(const SymbolValues& v, bool isInverted) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::min(v[2], v[0]);
    const double shoulder = isInverted ? x : x - cut;
    const double middle = isInverted ? x - cut : x;
    return plate(std::array<PointD, 5>{{{-x, -y}, {shoulder, -y}, {middle, 0}, {shoulder, y}, {-x, y}}}, v[3], v[4]);
}

/// fhplate W × H, vertical and horizontal cut, then ra and ro: a box whose two right corners are cut.
PadShape flatHomePlate(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double down = std::min(v[2], y);
    const double left = std::min(v[3], v[0]);
    return plate(
        std::array<PointD, 6>{{{-x, -y}, {x - left, -y}, {x, -y + down}, {x, y - down}, {x - left, y}, {-x, y}}}, v[4],
        v[5]);
}

/// radhplate W × H, middle curve, then ra: a box with a half circle of that diameter bitten out of its right end. The
/// radius rounds the four corners.
PadShape radiusedInvertedHomePlate(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double bite = std::min({v[2] / 2, y, v[0]});
    const double r = std::clamp(v[3], 0.0, std::min(x, y - bite));
    const auto at = [](double px, double py) { return rounded({px, py}); };
    const auto arc = EdgeKind::ArcCounterClockwise;
    const std::array<PathNode, 10> path = {{{at(-x, r - y), at(r - x, r - y), arc},
                                            lineNode(at(r - x, -y)),
                                            {at(x - r, -y), at(x - r, r - y), arc},
                                            lineNode(at(x, r - y)),
                                            {at(x, -bite), at(x, 0), EdgeKind::ArcClockwise},
                                            lineNode(at(x, bite)),
                                            {at(x, y - r), at(x - r, y - r), arc},
                                            lineNode(at(x - r, y)),
                                            {at(r - x, y), at(r - x, y - r), arc},
                                            lineNode(at(-x, y - r))}};
    std::vector<PathNode> nodes;
    for (const PathNode& node : path) {
        const bool isBite = node.edge == EdgeKind::ArcClockwise;
        const bool isPoint = node.edge != EdgeKind::Line && (isBite ? bite : r) == 0.0;
        nodes.push_back(isPoint ? lineNode(node.point) : node);
    }
    return drawn([&](ShapeSketch& sketch) { addPath(sketch, nodes, false); });
}

/// dshape W × H, relief, then ra: a box whose right end is an arc that bulges out by the relief. The radius rounds the
/// two left corners.
PadShape radiusedHomePlate(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double relief = std::min({v[2], v[0], y});
    const double r = std::clamp(v[3], 0.0, std::min(v[0] - relief, y));
    const auto at = [](double px, double py) { return rounded({px, py}); };
    std::vector<PathNode> nodes;
    if (r > 0) {
        nodes.push_back({at(-x, r - y), at(r - x, r - y), EdgeKind::ArcCounterClockwise});
    }
    nodes.push_back(lineNode(at(r - x, -y)));
    if (relief > 0) {
        // The circle through both ends of the arc and its top: radius = (y² + relief²) / (2 relief).
        const double radius = (y * y + relief * relief) / (2 * relief);
        nodes.push_back({at(x - relief, -y), at(x - radius, 0), EdgeKind::ArcCounterClockwise});
    } else {
        nodes.push_back(lineNode(at(x, -y)));
    }
    nodes.push_back(lineNode(at(x - relief, y)));
    if (r > 0) {
        nodes.push_back({at(r - x, y), at(r - x, y - r), EdgeKind::ArcCounterClockwise});
        nodes.push_back(lineNode(at(-x, y - r)));
    } else {
        nodes.push_back(lineNode(at(-x, y)));
    }
    return drawn([&](ShapeSketch& sketch) { addPath(sketch, nodes, false); });
}

/// Where a bar of this width lies between -half and half, its middle at `percent` of the distance, pushed inside.
double barMiddle(double percent, double half, double width) {
    return std::clamp((percent / 50.0 - 1.0) * half, width / 2 - half, half - width / 2);
}

/// W × H, width of the horizontal and of the vertical bar, crossing point in percent from the lower left, then the
/// radius of the inner corners.
PadShape cross(const SymbolValues& v, bool isRound) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double flat = std::min(v[2], v[1]);
    const double upright = std::min(v[3], v[0]);
    const double left = barMiddle(v[4], x, upright) - upright / 2;
    const double low = barMiddle(v[5], y, flat) - flat / 2;
    const double right = left + upright;
    const double high = low + flat;
    const double endH = isRound ? flat / 2 : 0.0;
    const double endV = isRound ? upright / 2 : 0.0;
    ShapeSketch sketch;
    addRoundedLoop(sketch, std::array<Corner, 12>{{{{x, low}, endH},
                                                   {{x, high}, endH},
                                                   {{right, high}, v[6]},
                                                   {{right, y}, endV},
                                                   {{left, y}, endV},
                                                   {{left, high}, v[6]},
                                                   {{-x, high}, endH},
                                                   {{-x, low}, endH},
                                                   {{left, low}, v[6]},
                                                   {{left, -y}, endV},
                                                   {{right, -y}, endV},
                                                   {{right, low}, v[6]}}});
    return regionShape(std::move(sketch));
}

/// W × H, width of the two horizontal bars and of the vertical one, its position in percent from the left, then the
/// radius of the inner corners.
PadShape dogbone(const SymbolValues& v, bool isRound) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double flat = std::min(v[2], y);
    const double upright = std::min(v[3], v[0]);
    const double left = barMiddle(v[4], x, upright) - upright / 2;
    const double right = left + upright;
    const double end = isRound ? flat / 2 : 0.0;
    const double low = flat - y;
    ShapeSketch sketch;
    addRoundedLoop(sketch, std::array<Corner, 12>{{{{-x, -y}, end},
                                                   {{x, -y}, end},
                                                   {{x, low}, end},
                                                   {{right, low}, v[5]},
                                                   {{right, -low}, v[5]},
                                                   {{x, -low}, end},
                                                   {{x, y}, end},
                                                   {{-x, y}, end},
                                                   {{-x, -low}, end},
                                                   {{left, -low}, v[5]},
                                                   {{left, low}, v[5]},
                                                   {{-x, low}, end}}});
    return regionShape(std::move(sketch));
}

/// dpack W × H, horizontal and vertical gap, columns and rows, then the corner radius of each pad.
PadShape padGrid(const SymbolValues& v) {
    const int columns = static_cast<int>(std::lround(v[4]));
    const int rows = static_cast<int>(std::lround(v[5]));
    const double width = (v[0] - v[2] * (columns - 1)) / std::max(columns, 1);
    const double height = (v[1] - v[3] * (rows - 1)) / std::max(rows, 1);
    ShapeSketch sketch;
    for (int i = 0; width > 0 && height > 0 && i < columns * rows; ++i) {
        const double x = -v[0] / 2 + (i % columns) * (width + v[2]);
        const double y = -v[1] / 2 + (i / columns) * (height + v[3]);
        addRoundedLoop(
            sketch,
            std::array<Corner, 4>{
                {{{x, y}, v[6]}, {{x + width, y}, v[6]}, {{x + width, y + height}, v[6]}, {{x, y + height}, v[6]}}});
    }
    return regionShape(std::move(sketch));
}

constexpr SymbolRule kRules[] = {
    {"hplate#x#x#[x#x#]", [](const SymbolValues& v) { return homePlate(v, false); }, 2},
    {"rhplate#x#x#[x#x#]", [](const SymbolValues& v) { return homePlate(v, true); }, 2},
    {"fhplate#x#x#x#[x#x#]", flatHomePlate, 2},
    {"radhplate#x#x#[x#]", radiusedInvertedHomePlate, 2},
    {"dshape#x#x#[x#]", radiusedHomePlate, 2},
    {"cross#x#x#x#x@x@xr[#]", [](const SymbolValues& v) { return cross(v, true); }, 2},
    {"cross#x#x#x#x@x@xs[#]", [](const SymbolValues& v) { return cross(v, false); }, 2},
    {"dogbone#x#x#x#x@xr[x#]", [](const SymbolValues& v) { return dogbone(v, true); }, 2},
    {"dogbone#x#x#x#x@xs[x#]", [](const SymbolValues& v) { return dogbone(v, false); }, 2},
    {"dpack#x#x#x#x@x@[x#]", padGrid, 2, 0, 0b110000},
};

}  // namespace

std::span<const SymbolRule> stencilRules() {
    return kRules;
}

}  // namespace model::odb
