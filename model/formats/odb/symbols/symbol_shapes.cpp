#include "model/formats/odb/symbols/symbol_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "model/formats/common/region.h"
#include "model/geometry/boolean.h"

namespace model::odb {

namespace {

Nm whole(double nm) {
    return static_cast<Nm>(std::llround(nm));
}

SymbolShape polygon(std::span<const PointD> corners) {
    ShapeSketch sketch;
    addLoop(sketch, corners, false);
    return regionShape(std::move(sketch));
}

SymbolShape box(double width, double height) {
    ShapeSketch sketch;
    addBox(sketch, width, height, false);
    SymbolShape shape = regionShape(std::move(sketch));
    shape.width = whole(width);
    shape.height = whole(height);
    shape.isSquarePen = shape.width == shape.height;
    return shape;
}

}  // namespace

PathNode lineNode(Point point) {
    return {point, {}, EdgeKind::Line};
}

SymbolShape regionShape(ShapeSketch sketch) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Region;
    shape.region = std::move(sketch);
    return shape;
}

SymbolShape resized(const SymbolShape& shape, Nm resize) {
    SymbolShape result = regionShape(sketchOf(grow(polygonsOf(shape.region), resize / 2.0)));
    result.problem = shape.problem;
    if (result.region.isEmpty()) {
        result.kind = SymbolShape::Kind::Nothing;
        result.problem = "is resized to nothing";
    }
    return result;
}

SymbolShape roundShape(const SymbolValues& v) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Round;
    shape.width = whole(v[0]);
    return shape;
}

SymbolShape square(const SymbolValues& v) {
    return box(v[0], v[0]);
}

SymbolShape rectangle(const SymbolValues& v) {
    return box(v[0], v[1]);
}

SymbolShape roundedRectangle(const SymbolValues& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Rounded, false);
    return regionShape(std::move(sketch));
}

SymbolShape chamferedRectangle(const SymbolValues& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Chamfered, false);
    return regionShape(std::move(sketch));
}

SymbolShape ovalShape(const SymbolValues& v) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Oval;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    return shape;
}

SymbolShape diamond(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 4>{{{x, 0}, {0, y}, {-x, 0}, {0, -y}}});
}

SymbolShape hexagonLying(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, x);
    return polygon(std::array<PointD, 6>{{{x, 0}, {x - cut, y}, {cut - x, y}, {-x, 0}, {cut - x, -y}, {x - cut, -y}}});
}

SymbolShape hexagonStanding(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, y);
    return polygon(std::array<PointD, 6>{{{0, y}, {-x, y - cut}, {-x, cut - y}, {0, -y}, {x, cut - y}, {x, y - cut}}});
}

SymbolShape triangle(const SymbolValues& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 3>{{{0, y}, {-x, -y}, {x, -y}}});
}

SymbolShape ellipse(const SymbolValues& v) {
    ShapeSketch sketch;
    addEllipse(sketch, v[0], v[1]);
    return regionShape(std::move(sketch));
}

/// Flat end at −x, half circle of diameter H at +x, centred on its box.
SymbolShape halfOval(const SymbolValues& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[1] / 2, 0b1001, CornerStyle::Rounded, false);
    return regionShape(std::move(sketch));
}

SymbolShape roundRing(const SymbolValues& v) {
    SymbolShape shape;
    if (v[1] >= v[0]) {
        return regionShape({});  // all hole
    }
    shape.kind = v[1] > 0 ? SymbolShape::Kind::Ring : SymbolShape::Kind::Round;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    if (v[1] < 0) {
        shape.problem = "has a negative inner diameter; drawn as a disc";
    }
    return shape;
}

SymbolShape squareRing(const SymbolValues& v) {
    if (v[1] >= v[0]) {
        return regionShape({});
    }
    ShapeSketch sketch;
    addBox(sketch, v[0], v[0], false);
    addBox(sketch, v[1], v[1], true);
    return regionShape(std::move(sketch));
}

SymbolShape squareRoundRing(const SymbolValues& v) {
    if (v[1] >= v[0]) {
        return regionShape({});
    }
    ShapeSketch sketch;
    addBox(sketch, v[0], v[0], false);
    addDisc(sketch, v[1], true);
    return regionShape(std::move(sketch));
}

ShapeSketch boxRing(double width, double height, double line, double radius, unsigned corners) {
    ShapeSketch sketch;
    addCornerBox(sketch, width, height, radius, corners, CornerStyle::Rounded, false);
    if (width > 2 * line && height > 2 * line) {
        addCornerBox(sketch, width - 2 * line, height - 2 * line, radius - line, corners, CornerStyle::Rounded, true);
    }
    return sketch;
}

SymbolShape roundedSquareRing(const SymbolValues& v) {
    return regionShape(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[2], v.corners));
}

SymbolShape rectangleRing(const SymbolValues& v) {
    return regionShape(boxRing(v[0], v[1], v[2], v[3], v.corners));
}

SymbolShape ovalRing(const SymbolValues& v) {
    ShapeSketch sketch;
    addOval(sketch, v[0], v[1], false);
    if (std::min(v[0], v[1]) > 2 * v[2]) {
        addOval(sketch, v[0] - 2 * v[2], v[1] - 2 * v[2], true);
    }
    return regionShape(std::move(sketch));
}

/// Two opposite quadrants: top left and bottom right.
SymbolShape butterflyRound(const SymbolValues& v) {
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

SymbolShape butterflySquare(const SymbolValues& v) {
    const double h = v[0] / 2;
    ShapeSketch sketch;
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {0, h}, {-h, h}, {-h, 0}}}, false);
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {0, -h}, {h, -h}, {h, 0}}}, false);
    return regionShape(std::move(sketch));
}

}  // namespace model::odb
