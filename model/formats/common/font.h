#pragma once

#include <map>
#include <vector>

#include "model/geometry/shapes.h"

namespace model::formats {

/// One stroke of a character, in the font's own units.
struct FontStroke {
    PointD a;
    PointD b;
    double width = 0.012;  ///< of the pen, in inches, before the text's width factor
    bool isSquare = false;
    bool isNegative = false;  ///< takes away what the strokes before it have drawn
};

/// A stroke font whose characters are all as wide. The lower left corner of a character is that of the box around the
/// capitals and digits of the font.
class Font {
public:
    /// Width of a character with the space behind it, height, and what is added to the width.
    void setSize(double x, double y, double offset) {
        m_xSize = x;
        m_ySize = y;
        m_offset = offset;
    }
    void addCharacter(char32_t character) { m_glyphs.try_emplace(character); }
    void addStroke(char32_t character, const FontStroke& stroke);

    /// Strokes of a character with the lower left corner at the origin; empty for a space.
    [[nodiscard]] std::vector<FontStroke> strokes(char32_t character) const;
    [[nodiscard]] bool has(char32_t character) const { return m_glyphs.contains(character); }
    [[nodiscard]] bool isEmpty() const { return m_glyphs.empty(); }
    [[nodiscard]] double xSize() const { return m_xSize; }
    [[nodiscard]] double ySize() const { return m_ySize; }
    /// From one character to the next.
    [[nodiscard]] double advance() const { return m_xSize + m_offset; }

private:
    double m_xSize = 1.0;
    double m_ySize = 1.0;
    double m_offset = 0.0;
    PointD m_corner;
    bool m_hasCorner = false;
    std::map<char32_t, std::vector<FontStroke>> m_glyphs;
};

/// A plain font for ASCII that is part of Copperscope. It stands in where a file names a font it does not bring.
[[nodiscard]] const Font& standInFont();

}  // namespace model::formats
