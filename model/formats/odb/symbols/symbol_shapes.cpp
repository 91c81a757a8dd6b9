#include "model/formats/odb/symbols/symbol_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/boolean.h"
#include "model/geometry/region.h"

namespace model::odb {

namespace {

Nm whole(double nm) {
    return static_cast<Nm>(std::llround(nm));
}

PadShape polygon(std::span<const PointD> corners) {
    return drawn([&](ShapeSketch& sketch) { addLoop(sketch, corners, false); });
}

PadShape box(double width, double height) {
    PadShape shape = drawn([&](ShapeSketch& sketch) { addBox(sketch, width, height, false); });
    shape.width = whole(width);
    shape.height = whole(height);
    shape.isSquarePen = shape.width == shape.height;
    return shape;
}

}  // namespace

PointD polar(double angle, double along, double aside) {
    return {along * std::cos(angle) - aside * std::sin(angle), along * std::sin(angle) + aside * std::cos(angle)};
}

PathNode lineNode(Point point) {
    return {point, {}, EdgeKind::Line};
}

PadShape regionShape(ShapeSketch sketch) {
    PadShape shape;
    shape.kind = PadShape::Kind::Region;
    shape.region = std::move(sketch);
    return shape;
}

PadShape resized(const PadShape& shape, Nm resize) {
    PadShape result = regionShape(sketchOf(grow(polygonsOf(shape.region), resize / 2.0)));
    result.problem = shape.problem;
    if (result.region.isEmpty()) {
        result.kind = PadShape::Kind::Nothing;
        result.problem = "is resized to nothing";
    }
    return result;
}

ShapeSketch boxRing(double width, double height, double line, double radius, unsigned corners) {
    ShapeSketch sketch;
    addCornerBox(sketch, width, height, radius, corners, CornerStyle::Rounded, false);
    if (width > 2 * line && height > 2 * line) {
        addCornerBox(sketch, width - 2 * line, height - 2 * line, radius - line, corners, CornerStyle::Rounded, true);
    }
    return sketch;
}

ShapeSketch ovalRing(double width, double height, double line) {
    ShapeSketch sketch;
    addOval(sketch, width, height, false);
    if (std::min(width, height) > 2 * line) {
        addOval(sketch, width - 2 * line, height - 2 * line, true);
    }
    return sketch;
}

ShapeSketch squareRoundRing(double outer, double inner) {
    ShapeSketch sketch;
    if (inner < outer) {
        addBox(sketch, outer, outer, false);
        addDisc(sketch, inner, true);
    }
    return sketch;
}

namespace {

PadShape roundShape(const SymbolValues& v) {
    PadShape shape;
    shape.kind = PadShape::Kind::Round;
    shape.width = whole(v[0]);
    return shape;
}

PadShape square(const SymbolValues& v) {
    return box(v[0], v[0]);
}

PadShape rectangle(const SymbolValues& v) {
    return box(v[0], v[1]);
}

PadShape roundedRectangle(const SymbolValues& v) {
    return drawn(
        [&](ShapeSketch& sketch) { addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Rounded, false); });
}

PadShape chamferedRectangle(const SymbolValues& v) {
    return drawn(
        [&](ShapeSketch& sketch) { addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Chamfered, false); });
}

PadShape ovalShape(const SymbolValues& v) {
    PadShape shape;
    shape.kind = PadShape::Kind::Oval;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    return shape;
}

PadShape diamond(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 4>{{{x, 0}, {0, y}, {-x, 0}, {0, -y}}});
}

PadShape hexagonLying(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, x);
    return polygon(std::array<PointD, 6>{{{x, 0}, {x - cut, y}, {cut - x, y}, {-x, 0}, {cut - x, -y}, {x - cut, -y}}});
}

PadShape hexagonStanding(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, y);
    return polygon(std::array<PointD, 6>{{{0, y}, {-x, y - cut}, {-x, cut - y}, {0, -y}, {x, cut - y}, {x, y - cut}}});
}

PadShape triangle(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 3>{{{0, y}, {-x, -y}, {x, -y}}});
}

PadShape ellipse(const SymbolValues& v) {
    return drawn([&](ShapeSketch& sketch) { addEllipse(sketch, v[0], v[1]); });
}

/// Flat end at −x, half circle of diameter H at +x, centred on its box.
PadShape halfOval(const SymbolValues& v) {
    return drawn(
        [&](ShapeSketch& sketch) { addCornerBox(sketch, v[0], v[1], v[1] / 2, 0b1001, CornerStyle::Rounded, false); });
}

PadShape roundRing(const SymbolValues& v) {
    PadShape shape;
    if (v[1] >= v[0]) {
        return regionShape({});  // all hole
    }
    shape.kind = v[1] > 0 ? PadShape::Kind::Ring : PadShape::Kind::Round;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    if (v[1] < 0) {
        shape.problem = "has a negative inner diameter; drawn as a disc";
    }
    return shape;
}

PadShape squareRing(const SymbolValues& v) {
    if (v[1] >= v[0]) {
        return regionShape({});
    }
    ShapeSketch sketch;
    addBox(sketch, v[0], v[0], false);
    addBox(sketch, v[1], v[1], true);
    return regionShape(std::move(sketch));
}

PadShape squareRoundRingShape(const SymbolValues& v) {
    return regionShape(squareRoundRing(v[0], v[1]));
}

PadShape roundedSquareRing(const SymbolValues& v) {
    return regionShape(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[2], v.corners));
}

PadShape rectangleRing(const SymbolValues& v) {
    return regionShape(boxRing(v[0], v[1], v[2], v[3], v.corners));
}

PadShape ovalRingShape(const SymbolValues& v) {
    return regionShape(ovalRing(v[0], v[1], v[2]));
}

/// Two opposite quadrants: top left and bottom right.
PadShape butterflyRound(const SymbolValues& v) {
    const Nm r = whole(v[0] / 2);
    ShapeSketch sketch;
    addPath(
        sketch,
        std::array<PathNode, 3>{{lineNode({0, 0}), {{0, r}, {0, 0}, EdgeKind::ArcCounterClockwise}, lineNode({-r, 0})}},
        false);
    addPath(
        sketch,
        std::array<PathNode, 3>{{lineNode({0, 0}), {{0, -r}, {0, 0}, EdgeKind::ArcCounterClockwise}, lineNode({r, 0})}},
        false);
    return regionShape(std::move(sketch));
}

PadShape butterflySquare(const SymbolValues& v) {
    const double h = v[0] / 2;
    ShapeSketch sketch;
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {0, h}, {-h, h}, {-h, 0}}}, false);
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {0, -h}, {h, -h}, {h, 0}}}, false);
    return regionShape(std::move(sketch));
}

PadShape nothing(const SymbolValues&) {
    return {};
}

constexpr SymbolRule kRules[] = {
    {"r#", roundShape, 1},
    {"s#", square, 1},
    {"rect#x#", rectangle, 2},
    {"rect#x#xr#[x%]", roundedRectangle, 2},
    {"rect#x#xc#[x%]", chamferedRectangle, 2},
    {"oval#x#", ovalShape, 2},
    {"donut_r#x#", roundRing, 1, 0b10},
    {"donut_rc#x#x#[xr#[x%]]", rectangleRing, 2},
    {"oct#x#x#", chamferedRectangle, 2},
    {"di#x#", diamond, 2},
    {"hex_l#x#x#", hexagonLying, 2},
    {"hex_s#x#x#", hexagonStanding, 2},
    {"tri#x#", triangle, 2},
    {"el#x#", ellipse, 2},
    {"oval_h#x#", halfOval, 2},
    {"bfr#", butterflyRound, 1},
    {"bfs#", butterflySquare, 1},
    {"donut_s#x#", squareRing, 1},
    {"donut_s#x#xr#[x%]", roundedSquareRing, 1},
    {"donut_sr#x#", squareRoundRingShape, 1},
    {"donut_o#x#x#", ovalRingShape, 2},
    {"moire#x#x@x#x#x@", moire, 0, 0, 0b100},
    {"hole#xpx@x@", roundShape, 1},
    {"hole#xnx@x@", roundShape, 1},
    {"hole#xvx@x@", roundShape, 1},
    {"null@", nothing},
};

}  // namespace

std::span<const SymbolRule> padRules() {
    return kRules;
}

}  // namespace model::odb
