#pragma once

#include <array>
#include <cstddef>

#include "model/formats/common/outlines.h"
#include "model/formats/odb/symbols/standard_symbols.h"

/// The makers behind standardSymbol: each turns the values of a symbol name into what the symbol draws. The grammar and
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
[[nodiscard]] ShapeSketch boxRing(double width, double height, double line, double radius, unsigned corners);
[[nodiscard]] SymbolShape regionShape(ShapeSketch sketch);
/// A node that a straight edge leaves.
[[nodiscard]] PathNode lineNode(Point point);

[[nodiscard]] SymbolShape roundShape(const SymbolValues& v);
[[nodiscard]] SymbolShape square(const SymbolValues& v);
[[nodiscard]] SymbolShape rectangle(const SymbolValues& v);
[[nodiscard]] SymbolShape roundedRectangle(const SymbolValues& v);
[[nodiscard]] SymbolShape chamferedRectangle(const SymbolValues& v);
[[nodiscard]] SymbolShape ovalShape(const SymbolValues& v);
[[nodiscard]] SymbolShape diamond(const SymbolValues& v);
[[nodiscard]] SymbolShape hexagonLying(const SymbolValues& v);
[[nodiscard]] SymbolShape hexagonStanding(const SymbolValues& v);
[[nodiscard]] SymbolShape triangle(const SymbolValues& v);
[[nodiscard]] SymbolShape ellipse(const SymbolValues& v);
[[nodiscard]] SymbolShape halfOval(const SymbolValues& v);
[[nodiscard]] SymbolShape roundRing(const SymbolValues& v);
[[nodiscard]] SymbolShape squareRing(const SymbolValues& v);
[[nodiscard]] SymbolShape squareRoundRing(const SymbolValues& v);
[[nodiscard]] SymbolShape roundedSquareRing(const SymbolValues& v);
[[nodiscard]] SymbolShape rectangleRing(const SymbolValues& v);
[[nodiscard]] SymbolShape ovalRing(const SymbolValues& v);
[[nodiscard]] SymbolShape butterflyRound(const SymbolValues& v);
[[nodiscard]] SymbolShape butterflySquare(const SymbolValues& v);

// thermal_shapes.cpp
[[nodiscard]] SymbolShape roundThermalSquareEnds(const SymbolValues& v);
[[nodiscard]] SymbolShape roundThermalRoundEnds(const SymbolValues& v);
[[nodiscard]] SymbolShape squareThermal(const SymbolValues& v);
[[nodiscard]] SymbolShape squareRoundThermal(const SymbolValues& v);
[[nodiscard]] SymbolShape rectangleThermal(const SymbolValues& v);
[[nodiscard]] SymbolShape ovalThermal(const SymbolValues& v);
[[nodiscard]] SymbolShape squareThermalOpenCorners(const SymbolValues& v);
[[nodiscard]] SymbolShape rectangleThermalOpenCorners(const SymbolValues& v);
[[nodiscard]] SymbolShape lineThermal(const SymbolValues& v);
[[nodiscard]] SymbolShape oblongThermalStraight(const SymbolValues& v);

// moire.cpp
[[nodiscard]] SymbolShape moire(const SymbolValues& v);

// stencil_shapes.cpp
[[nodiscard]] SymbolShape homePlate(const SymbolValues& v);
[[nodiscard]] SymbolShape invertedHomePlate(const SymbolValues& v);
[[nodiscard]] SymbolShape flatHomePlate(const SymbolValues& v);
[[nodiscard]] SymbolShape radiusedInvertedHomePlate(const SymbolValues& v);
[[nodiscard]] SymbolShape radiusedHomePlate(const SymbolValues& v);
[[nodiscard]] SymbolShape crossRound(const SymbolValues& v);
[[nodiscard]] SymbolShape crossSquare(const SymbolValues& v);
[[nodiscard]] SymbolShape dogboneRound(const SymbolValues& v);
[[nodiscard]] SymbolShape dogboneSquare(const SymbolValues& v);
[[nodiscard]] SymbolShape padGrid(const SymbolValues& v);

}  // namespace model::odb
