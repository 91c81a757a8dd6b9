#pragma once

#include <array>
#include <cstddef>

#include "model/formats/odb/symbols/standard_symbols.h"
#include "model/geometry/outlines.h"

/// The makers behind standardSymbol: each makes what the symbol draws of the values of its name. The grammar and
/// the meaning of the values are the rows of the table in standard_symbols.cpp.
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
/// A node that a straight edge leaves.
[[nodiscard]] PathNode lineNode(Point point);

[[nodiscard]] PadShape roundShape(const SymbolValues& v);
[[nodiscard]] PadShape square(const SymbolValues& v);
[[nodiscard]] PadShape rectangle(const SymbolValues& v);
[[nodiscard]] PadShape roundedRectangle(const SymbolValues& v);
[[nodiscard]] PadShape chamferedRectangle(const SymbolValues& v);
[[nodiscard]] PadShape ovalShape(const SymbolValues& v);
[[nodiscard]] PadShape diamond(const SymbolValues& v);
[[nodiscard]] PadShape hexagonLying(const SymbolValues& v);
[[nodiscard]] PadShape hexagonStanding(const SymbolValues& v);
[[nodiscard]] PadShape triangle(const SymbolValues& v);
[[nodiscard]] PadShape ellipse(const SymbolValues& v);
[[nodiscard]] PadShape halfOval(const SymbolValues& v);
[[nodiscard]] PadShape roundRing(const SymbolValues& v);
[[nodiscard]] PadShape squareRing(const SymbolValues& v);
[[nodiscard]] PadShape squareRoundRing(const SymbolValues& v);
[[nodiscard]] PadShape roundedSquareRing(const SymbolValues& v);
[[nodiscard]] PadShape rectangleRing(const SymbolValues& v);
[[nodiscard]] PadShape ovalRing(const SymbolValues& v);
[[nodiscard]] PadShape butterflyRound(const SymbolValues& v);
[[nodiscard]] PadShape butterflySquare(const SymbolValues& v);

// thermal_shapes.cpp
[[nodiscard]] PadShape roundThermalSquareEnds(const SymbolValues& v);
[[nodiscard]] PadShape roundThermalRoundEnds(const SymbolValues& v);
[[nodiscard]] PadShape squareThermal(const SymbolValues& v);
[[nodiscard]] PadShape squareRoundThermal(const SymbolValues& v);
[[nodiscard]] PadShape rectangleThermal(const SymbolValues& v);
[[nodiscard]] PadShape ovalThermal(const SymbolValues& v);
[[nodiscard]] PadShape squareThermalOpenCorners(const SymbolValues& v);
[[nodiscard]] PadShape rectangleThermalOpenCorners(const SymbolValues& v);
[[nodiscard]] PadShape lineThermal(const SymbolValues& v);
[[nodiscard]] PadShape oblongThermalStraight(const SymbolValues& v);

// moire.cpp
[[nodiscard]] PadShape moire(const SymbolValues& v);

// stencil_shapes.cpp
[[nodiscard]] PadShape homePlate(const SymbolValues& v);
[[nodiscard]] PadShape invertedHomePlate(const SymbolValues& v);
[[nodiscard]] PadShape flatHomePlate(const SymbolValues& v);
[[nodiscard]] PadShape radiusedInvertedHomePlate(const SymbolValues& v);
[[nodiscard]] PadShape radiusedHomePlate(const SymbolValues& v);
[[nodiscard]] PadShape cross(const SymbolValues& v, bool isRound);
[[nodiscard]] PadShape dogbone(const SymbolValues& v, bool isRound);
[[nodiscard]] PadShape padGrid(const SymbolValues& v);

}  // namespace model::odb
