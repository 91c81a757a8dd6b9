#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "model/formats/odb/symbols/standard_symbols.h"
#include "model/geometry/outlines.h"

/// The kinds of symbols behind standardSymbol: each has a maker of what the symbol draws of the values of its name.
namespace model::odb {

/// Values taken out of a symbol name in their order; lengths are in nanometres, angles and counts as written.
struct SymbolValues {
    std::array<double, 8> at{};
    std::size_t count = 0;
    std::size_t lengths = 0;  ///< bit set of those that are lengths
    unsigned corners = kAllCorners;

    double operator[](std::size_t i) const { return at[i]; }
};

/// A ring of even line width: outer box, and an inner one with the radius reduced by the line width (odb-notes,
/// Symbols).
[[nodiscard]] ShapeSketch ovalRing(double width, double height, double line);
[[nodiscard]] ShapeSketch boxRing(double width, double height, double line, double radius, unsigned corners);
[[nodiscard]] PadShape regionShape(ShapeSketch sketch);
/// The region that `draw(sketch)` draws.
template <class Draw>
[[nodiscard]] PadShape drawn(Draw draw) {
    ShapeSketch sketch;
    draw(sketch);
    return regionShape(std::move(sketch));
}
/// A point at distance `along` from the centre in direction `angle` (rad), `aside` to the left of that direction.
[[nodiscard]] PointD polar(double angle, double along, double aside = 0.0);
/// A node that a straight edge leaves.
[[nodiscard]] PathNode lineNode(Point point);

/// Square outside, round inside: outer and inner size.
[[nodiscard]] ShapeSketch squareRoundRing(double outer, double inner);
/// moire: ring width, ring gap, rings, then the cross: line width, length, angle.
[[nodiscard]] PadShape moire(const SymbolValues& v);

/// A kind of symbol.
struct SymbolRule {
    /// `#` is a length, `@` a plain number, `%` a list of corners, and what `[` and `]` enclose may be left out; the
    /// rest stands for itself. No name fits two patterns.
    std::string_view pattern;
    PadShape (*make)(const SymbolValues&);
    std::size_t resizable = 0;      ///< leading lengths, the outer sizes: a resize is added to them; 0: none has one
    std::size_t mayBeNegative = 0;  ///< bit set of lengths that may be negative
    std::size_t counts = 0;         ///< bit set of values that count pieces (gaps, rings, rows)
};
[[nodiscard]] std::span<const SymbolRule> padRules();
[[nodiscard]] std::span<const SymbolRule> thermalRules();
[[nodiscard]] std::span<const SymbolRule> stencilRules();

}  // namespace model::odb
