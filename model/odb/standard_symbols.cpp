#include "model/odb/standard_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "model/odb/records.h"
#include "model/odb/symbol_shapes.h"

namespace model::odb {

namespace {

/// Takes a number off the front of `name`.
bool takeNumber(std::string_view& name, bool isLength, double nmPerUnit, SymbolValues& values) {
    const std::size_t sign = name.starts_with('-') ? 1 : 0;
    const std::size_t length = std::min(name.find_first_not_of("0123456789.", sign), name.size());
    const std::optional<double> value = parseReal(name.substr(0, length));
    if (!value || values.count == values.at.size()) {
        return false;
    }
    values.lengths |= isLength ? std::size_t{1} << values.count : 0;
    values.at[values.count++] = isLength ? *value * nmPerUnit : *value;
    name.remove_prefix(length);
    return true;
}

/// Takes a list of corners off the front of `name`: digits 1 to 4.
bool takeCorners(std::string_view& name, SymbolValues& values) {
    const std::size_t length = std::min(name.find_first_not_of("1234"), name.size());
    values.corners = 0;
    for (const char digit : name.substr(0, length)) {
        values.corners |= 1U << static_cast<unsigned>(digit - '1');
    }
    name.remove_prefix(length);
    return length > 0;
}

/// In a pattern `#` is a length, `@` a plain number and `%` a list of corners; the rest stands for itself.
bool matches(std::string_view pattern, std::string_view name, double nmPerUnit, SymbolValues& values) {
    for (const char p : pattern) {
        bool fits = false;
        if (p == '#' || p == '@') {
            fits = takeNumber(name, p == '#', nmPerUnit, values);
        } else if (p == '%') {
            fits = takeCorners(name, values);
        } else {
            fits = name.starts_with(p);
            name.remove_prefix(fits ? 1 : 0);
        }
        if (!fits) {
            return false;
        }
    }
    return name.empty();
}

SymbolShape nothing(const SymbolValues&) {
    return {};
}

SymbolShape notYet(const SymbolValues&) {
    SymbolShape shape;
    shape.problem = "is a standard symbol that cannot be drawn yet; it draws nothing";
    return shape;
}

struct Rule {
    std::string_view pattern;
    SymbolShape (*make)(const SymbolValues&);
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
    {"oblong_ths#x#x@x@x#x#xs", ovalThermal},
    {"oblong_ths#x#x@x@x#x#xr", notYet},
    {"s_tho#x#x@x@x#", notYet},
    {"s_tho#x#x@x@x#xr#", notYet},
    {"s_tho#x#x@x@x#xr#x%", notYet},
    {"s_thr#x#x@x@x#", notYet},
    {"rc_tho#x#x@x@x#x#", notYet},
    {"rc_tho#x#x@x@x#x#xr#", notYet},
    {"rc_tho#x#x@x@x#x#xr#x%", notYet},
    {"moire#x#x@x#x#x@", moire},
    {"null@", nothing},
});

/// Half a metre: symbols placed anywhere in the coordinate range then stay within 32 bits.
constexpr double kMaxSymbol = base::kMaxCoordinate / 2.0;

/// A reason why these sizes cannot be drawn, or nothing.
std::string_view badSize(const SymbolValues& values, const Rule& rule) {
    for (std::size_t i = 0; i < values.count; ++i) {
        const bool isLength = (values.lengths >> i & 1U) != 0;
        if (isLength && std::abs(values[i]) > kMaxSymbol) {
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

SymbolShape makeShape(const Rule& rule, SymbolValues values, Nm resize) {
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
        SymbolValues values;
        if (matches(rule.pattern, symbol.name, static_cast<double>(symbolNm(symbol.unit)), values)) {
            return makeShape(rule, values, symbol.resize);
        }
    }
    return std::nullopt;
}

}  // namespace model::odb
