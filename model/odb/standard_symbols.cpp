#include "model/odb/standard_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "model/geometry/boolean.h"
#include "model/odb/outlines.h"
#include "model/odb/records.h"
#include "model/odb/region.h"

namespace model::odb {

namespace {

/// Values taken out of a symbol name in their order; lengths are in nanometres, angles and counts as written.
struct Values {
    std::array<double, 8> at{};
    std::size_t count = 0;
    std::size_t lengths = 0;  ///< bit set of those that are lengths
    unsigned corners = kAllCorners;
    std::array<char, 2> letters{};
    std::size_t letterCount = 0;

    double operator[](std::size_t i) const { return at[i]; }
};

/// `#` is a length, `@` a plain number, `%` a list of corners, `?` one letter; the rest stands for itself.
bool matches(std::string_view pattern, std::string_view name, double nmPerUnit, Values& values) {
    for (const char p : pattern) {
        if (p == '#' || p == '@') {
            std::size_t length = name.starts_with('-') ? 1 : 0;
            length = std::min(name.find_first_not_of("0123456789.", length), name.size());
            const std::optional<double> value = parseReal(name.substr(0, length));
            if (!value || values.count == values.at.size()) {
                return false;
            }
            values.lengths |= p == '#' ? std::size_t{1} << values.count : 0;
            values.at[values.count++] = p == '#' ? *value * nmPerUnit : *value;
            name.remove_prefix(length);
        } else if (p == '%') {
            const std::size_t length = std::min(name.find_first_not_of("1234"), name.size());
            values.corners = 0;
            for (const char digit : name.substr(0, length)) {
                values.corners |= 1U << static_cast<unsigned>(digit - '1');
            }
            name.remove_prefix(length);
            if (length == 0) {
                return false;
            }
        } else if (name.empty() || (p != '?' && name[0] != p)) {
            return false;
        } else {
            if (p == '?') {
                values.letters[values.letterCount++] = name[0];
            }
            name.remove_prefix(1);
        }
    }
    return name.empty();
}

Nm whole(double nm) {
    return static_cast<Nm>(std::llround(nm));
}

PathNode lineNode(Point point) {
    return {point, {}, EdgeKind::Line};
}

SymbolShape region(ShapeSketch sketch) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Region;
    shape.region = std::move(sketch);
    return shape;
}

/// A convex region with straight sides can also be a pen.
SymbolShape polygon(ShapeSketch sketch) {
    SymbolShape shape = region(std::move(sketch));
    for (const PathNode& node : shape.region.contour(0)) {
        shape.penCorners.push_back(node.point);
    }
    return shape;
}

SymbolShape polygon(std::span<const PointD> corners) {
    ShapeSketch sketch;
    addLoop(sketch, corners, false);
    return polygon(std::move(sketch));
}

SymbolShape roundShape(const Values& v) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Round;
    shape.width = whole(v[0]);
    return shape;
}

SymbolShape box(double width, double height) {
    ShapeSketch sketch;
    addBox(sketch, width, height, false);
    SymbolShape shape = polygon(std::move(sketch));
    shape.width = whole(width);
    shape.height = whole(height);
    shape.isSquarePen = shape.width == shape.height;
    return shape;
}

SymbolShape square(const Values& v) {
    return box(v[0], v[0]);
}

SymbolShape rectangle(const Values& v) {
    return box(v[0], v[1]);
}

SymbolShape roundedRectangle(const Values& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Rounded, false);
    return region(std::move(sketch));
}

SymbolShape chamferedRectangle(const Values& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[2], v.corners, CornerStyle::Chamfered, false);
    return polygon(std::move(sketch));
}

SymbolShape ovalShape(const Values& v) {
    SymbolShape shape;
    shape.kind = SymbolShape::Kind::Oval;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    return shape;
}

SymbolShape diamond(const Values& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 4>{{{x, 0}, {0, y}, {-x, 0}, {0, -y}}});
}

SymbolShape hexagonLying(const Values& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, x);
    return polygon(std::array<PointD, 6>{{{x, 0}, {x - cut, y}, {cut - x, y}, {-x, 0}, {cut - x, -y}, {x - cut, -y}}});
}

SymbolShape hexagonStanding(const Values& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    const double cut = std::clamp(v[2], 0.0, y);
    return polygon(std::array<PointD, 6>{{{0, y}, {-x, y - cut}, {-x, cut - y}, {0, -y}, {x, cut - y}, {x, y - cut}}});
}

SymbolShape triangle(const Values& v) {
    const double x = v[0] / 2;
    const double y = v[1] / 2;
    return polygon(std::array<PointD, 3>{{{0, y}, {-x, -y}, {x, -y}}});
}

SymbolShape ellipse(const Values& v) {
    ShapeSketch sketch;
    addEllipse(sketch, v[0], v[1]);
    return region(std::move(sketch));
}

/// Flat end at −x, half circle of diameter H at +x, centred on its box.
SymbolShape halfOval(const Values& v) {
    ShapeSketch sketch;
    addCornerBox(sketch, v[0], v[1], v[1] / 2, 0b1001, CornerStyle::Rounded, false);
    return region(std::move(sketch));
}

SymbolShape roundRing(const Values& v) {
    SymbolShape shape;
    shape.kind = v[1] > 0 ? SymbolShape::Kind::Ring : SymbolShape::Kind::Round;
    shape.width = whole(v[0]);
    shape.height = whole(v[1]);
    if (v[1] < 0) {
        shape.problem = "has a negative inner diameter; drawn as a disc";
    }
    return shape;
}

SymbolShape squareRing(const Values& v) {
    ShapeSketch sketch;
    addBox(sketch, v[0], v[0], false);
    addBox(sketch, v[1], v[1], true);
    return region(std::move(sketch));
}

SymbolShape squareRoundRing(const Values& v) {
    ShapeSketch sketch;
    addBox(sketch, v[0], v[0], false);
    addDisc(sketch, v[1], true);
    return region(std::move(sketch));
}

/// A ring of even line width: outer box, and an inner one with the radius reduced by the line width (facts §5).
ShapeSketch boxRing(double width, double height, double line, double radius, unsigned corners) {
    ShapeSketch sketch;
    addCornerBox(sketch, width, height, radius, corners, CornerStyle::Rounded, false);
    if (width > 2 * line && height > 2 * line) {
        addCornerBox(sketch, width - 2 * line, height - 2 * line, radius - line, corners, CornerStyle::Rounded, true);
    }
    return sketch;
}

SymbolShape roundedSquareRing(const Values& v) {
    return region(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[2], v.corners));
}

SymbolShape rectangleRing(const Values& v) {
    return region(boxRing(v[0], v[1], v[2], v[3], v.corners));
}

SymbolShape ovalRing(const Values& v) {
    ShapeSketch sketch;
    addOval(sketch, v[0], v[1], false);
    if (std::min(v[0], v[1]) > 2 * v[2]) {
        addOval(sketch, v[0] - 2 * v[2], v[1] - 2 * v[2], true);
    }
    return region(std::move(sketch));
}

/// Two opposite quadrants: top left and bottom right stay empty.
SymbolShape butterflyRound(const Values& v) {
    const Nm r = whole(v[0] / 2);
    ShapeSketch sketch;
    addPath(
        sketch,
        std::array<PathNode, 3>{{lineNode({0, 0}), {{r, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, lineNode({0, r})}},
        false);
    addPath(sketch,
            std::array<PathNode, 3>{
                {lineNode({0, 0}), {{-r, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, lineNode({0, -r})}},
            false);
    return region(std::move(sketch));
}

SymbolShape butterflySquare(const Values& v) {
    const double h = v[0] / 2;
    ShapeSketch sketch;
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {h, 0}, {h, h}, {0, h}}}, false);
    addLoop(sketch, std::array<PointD, 4>{{{0, 0}, {-h, 0}, {-h, -h}, {0, -h}}}, false);
    return region(std::move(sketch));
}

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
    return region(sketchOf(subtract(polygonsOf(ring), gapStrips(gapAngles(first, count), gap, reach))));
}

/// ths: the ends of each piece are parallel to the gap beside it. Exact: four corners and two arcs per piece.
SymbolShape roundThermalSquareEnds(const Values& v) {
    const double outer = v[0] / 2;
    const double inner = v[1] / 2;
    const std::vector<double> gaps = gapAngles(v[2], v[3]);
    if (gaps.empty() || v[4] / 2 >= inner) {
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
    return region(std::move(sketch));
}

/// thr: each piece is a stroke along the middle circle with round ends that touch the gap.
SymbolShape roundThermalRoundEnds(const Values& v) {
    const double line = (v[0] - v[1]) / 2;
    const double middle = (v[0] + v[1]) / 4;
    const std::vector<double> gaps = gapAngles(v[2], v[3]);
    const double aside = v[4] / 2 + line / 2;
    ShapeSketch sketch;
    if (gaps.empty() || aside >= middle * std::sin(std::min(std::numbers::pi / 2,
                                                            std::numbers::pi / static_cast<double>(gaps.size())))) {
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
    return region(std::move(sketch));
}

/// s_ths, with rounded corners when a radius follows: OS × IS, angle, gaps, gap width.
SymbolShape squareThermal(const Values& v) {
    return cutByGaps(boxRing(v[0], v[0], (v[0] - v[1]) / 2, v[5], v.corners), v[2], v[3], v[4], v[0]);
}

/// sr_ths: square outside, round inside.
SymbolShape squareRoundThermal(const Values& v) {
    ShapeSketch ring;
    addBox(ring, v[0], v[0], false);
    addDisc(ring, v[1], true);
    return cutByGaps(ring, v[2], v[3], v[4], v[0]);
}

/// rc_ths: W × H, angle, gaps, gap width, line width, then a radius.
SymbolShape rectangleThermal(const Values& v) {
    return cutByGaps(boxRing(v[0], v[1], v[5], v[6], v.corners), v[2], v[3], v[4], v[0] + v[1]);
}

/// o_ths: W × H, angle, gaps, gap width, line width.
SymbolShape ovalThermal(const Values& v) {
    ShapeSketch ring;
    addOval(ring, v[0], v[1], false);
    if (std::min(v[0], v[1]) > 2 * v[5]) {
        addOval(ring, v[0] - 2 * v[5], v[1] - 2 * v[5], true);
    }
    return cutByGaps(ring, v[2], v[3], v[4], v[0] + v[1]);
}

/// moire: ring width, ring gap, rings, then the cross: line width, length, angle. Rings are counted from the outside of
/// a disc in the middle.
SymbolShape moire(const Values& v) {
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
    return region(sketchOf(unite(all)));
}

SymbolShape nothing(const Values&) {
    return {};
}

struct Rule {
    std::string_view pattern;
    SymbolShape (*make)(const Values&);
    std::size_t resizable = 0;      ///< leading lengths that a resize is added to; 0: it cannot be resized
    std::size_t mayBeNegative = 0;  ///< bit set of lengths that may be negative
};

constexpr auto kRules = std::to_array<Rule>({
    {"r#", roundShape, 1},
    {"s#", square, 1},
    {"rect#x#", rectangle, 2},
    {"rect#x#xr#", roundedRectangle, 2},
    {"rect#x#xr#x%", roundedRectangle, 2},
    {"rect#x#xc#", chamferedRectangle, 2},
    {"rect#x#xc#x%", chamferedRectangle, 2},
    {"oval#x#", ovalShape, 2},
    {"donut_r#x#", roundRing, 0, 0b10},
    {"donut_rc#x#x#", rectangleRing},
    {"donut_rc#x#x#xr#", rectangleRing},
    {"donut_rc#x#x#xr#x%", rectangleRing},
    {"oct#x#x#", chamferedRectangle, 2},
    {"di#x#", diamond, 2},
    {"hex_l#x#x#", hexagonLying, 2},
    {"hex_s#x#x#", hexagonStanding, 2},
    {"tri#x#", triangle, 2},
    {"el#x#", ellipse, 2},
    {"oval_h#x#", halfOval, 2},
    {"bfr#", butterflyRound, 1},
    {"bfs#", butterflySquare, 1},
    {"donut_s#x#", squareRing},
    {"donut_s#x#xr#", roundedSquareRing},
    {"donut_s#x#xr#x%", roundedSquareRing},
    {"donut_sr#x#", squareRoundRing},
    {"donut_o#x#x#", ovalRing},
    {"thr#x#x@x@x#", roundThermalRoundEnds},
    {"ths#x#x@x@x#", roundThermalSquareEnds},
    {"s_ths#x#x@x@x#", squareThermal},
    {"s_ths#x#x@x@x#xr#", squareThermal},
    {"s_ths#x#x@x@x#xr#x%", squareThermal},
    {"sr_ths#x#x@x@x#", squareRoundThermal},
    {"rc_ths#x#x@x@x#x#", rectangleThermal},
    {"rc_ths#x#x@x@x#x#xr#", rectangleThermal},
    {"rc_ths#x#x@x@x#x#xr#x%", rectangleThermal},
    {"o_ths#x#x@x@x#x#", ovalThermal},
    {"moire#x#x@x#x#x@", moire},
    {"null@", nothing},
});

/// A reason why these sizes cannot be drawn, or nothing.
std::string_view badSize(const Values& values, const Rule& rule) {
    for (std::size_t i = 0; i < values.count; ++i) {
        const bool isLength = (values.lengths >> i & 1U) != 0;
        if (isLength && std::abs(values[i]) > static_cast<double>(base::kMaxCoordinate)) {
            return "has an absurd size; it draws nothing";
        }
        if (isLength && values[i] < 0 && (rule.mayBeNegative >> i & 1U) == 0) {
            return "has a negative size; it draws nothing";
        }
    }
    return {};
}

bool hasArea(const ShapeSketch& sketch) {
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        const std::span<const PathNode> nodes = sketch.contour(i);
        const bool isCurved =
            std::ranges::any_of(nodes, [](const PathNode& node) { return node.edge != EdgeKind::Line; });
        if (isCurved || nodes.size() > 2) {
            return true;
        }
    }
    return false;
}

SymbolShape makeShape(const Rule& rule, Values values, Nm resize) {
    for (std::size_t i = 0; i < rule.resizable; ++i) {
        values.at[i] += resize;
    }
    SymbolShape shape;
    if (const std::string_view reason = badSize(values, rule); !reason.empty()) {
        shape.problem = reason;
        return shape;
    }
    shape = rule.make(values);
    if (shape.kind == SymbolShape::Kind::Region && !hasArea(shape.region)) {
        shape = {};
        shape.problem = "has no area; it draws nothing";
    }
    if (resize != 0 && rule.resizable == 0) {
        shape.problem = "cannot be resized; drawn in its own size";
    }
    return shape;
}

}  // namespace

std::optional<SymbolShape> standardSymbol(const SymbolRef& symbol) {
    for (const Rule& rule : kRules) {
        Values values;
        if (matches(rule.pattern, symbol.name, static_cast<double>(symbolNm(symbol.unit)), values)) {
            return makeShape(rule, values, symbol.resize);
        }
    }
    return std::nullopt;
}

}  // namespace model::odb
