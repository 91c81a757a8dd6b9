#include "model/formats/odb/symbols/standard_symbols.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "model/formats/odb/symbols/symbol_shapes.h"
#include "model/formats/odb/text/records.h"

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

/// Does a name follow SymbolRule::pattern?
bool matches(std::string_view pattern, std::string_view name, double nmPerUnit, SymbolValues& values) {
    for (const char p : pattern) {
        bool fits = p == ']';
        if (p == '[') {
            if (name.empty()) {
                return true;
            }
            fits = true;
        } else if (p == '#' || p == '@') {
            fits = takeNumber(name, p == '#', nmPerUnit, values);
        } else if (p == '%') {
            fits = takeCorners(name, values);
        } else if (p != ']') {
            fits = name.starts_with(p);
            name.remove_prefix(fits ? 1 : 0);
        }
        if (!fits) {
            return false;
        }
    }
    return name.empty();
}

/// Half a metre: symbols placed anywhere in the coordinate range then stay within 32 bits.
constexpr double kMaxSymbol = base::kMaxCoordinate / 2.0;

/// So many gaps, rings, rows or columns at most: a limit of ours, far from what boards use.
constexpr double kMostPieces = 100.0;

bool isBadCount(double pieces) {
    return pieces < 0 || pieces > kMostPieces;
}

/// A reason why these sizes cannot be drawn, or nothing.
std::string_view badSize(const SymbolValues& values, const SymbolRule& rule) {
    for (std::size_t i = 0; i < values.count; ++i) {
        const bool isLength = (values.lengths >> i & 1U) != 0;
        if (isLength && std::abs(values[i]) > kMaxSymbol) {
            return "is larger than half a metre; it draws nothing";
        }
        if (isLength && values[i] < 0 && (rule.mayBeNegative >> i & 1U) == 0) {
            return "has a negative size; it draws nothing";
        }
        if ((rule.counts >> i & 1U) != 0 && isBadCount(values[i])) {
            return "counts pieces below 0 or above 100; it draws nothing";
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

PadShape makeShape(const SymbolRule& rule, SymbolValues values, Nm resize) {
    for (std::size_t i = 0; i < rule.resizable; ++i) {
        values.at[i] += resize;
    }
    PadShape shape;
    if (const std::string_view reason = badSize(values, rule); !reason.empty()) {
        shape.problem = reason;
        return shape;
    }
    shape = rule.make(values);
    if (shape.kind == PadShape::Kind::Region && !hasArea(shape.region)) {
        shape = {};
        shape.problem = "has no area; it draws nothing";
    }
    const bool isInName = rule.resizable > 0;
    return resize == 0 || isInName ? shape : resized(shape, resize);
}

}  // namespace

std::optional<PadShape> standardSymbol(const SymbolRef& symbol) {
    for (const std::span<const SymbolRule> rules : {padRules(), thermalRules(), stencilRules()}) {
        for (const SymbolRule& rule : rules) {
            SymbolValues values;
            if (matches(rule.pattern, symbol.name, static_cast<double>(symbolNm(symbol.unit)), values)) {
                return makeShape(rule, values, symbol.resize);
            }
        }
    }
    return std::nullopt;
}

}  // namespace model::odb
