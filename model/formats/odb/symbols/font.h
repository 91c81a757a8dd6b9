#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/formats/odb/text/job_tree.h"
#include "model/geometry/shapes.h"

namespace model::odb {

/// One stroke of a character, in the font's own units.
struct FontStroke {
    PointD a;
    PointD b;
    double width = 0.012;  ///< of the pen, in inches, before the text's width factor
    bool isSquare = false;
    bool isNegative = false;  ///< takes away what the strokes before it have drawn
};

/// A stroke font, as `fonts/<name>` of a job defines it:
///
///     XSIZE 0.302     width of a character with the space behind it
///     YSIZE 0.302     height
///     OFFSET 0        added to the width
///     CHAR A
///     LINE xs ys xe ye P|N R|S width
///     ECHAR
///
/// The lower left corner of a character is that of the box around the capitals and digits of the font.
class Font {
public:
    void setSize(double x, double y, double offset);
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

[[nodiscard]] Font parseFont(std::string_view text, std::string_view path, Diagnostics& diagnostics);

/// A plain font for ASCII that is part of Copperscope. It stands in where a job has none.
[[nodiscard]] const Font& standInFont();

/// The fonts of a job by name, each read when it is first asked for. A job without the font gets the stand-in, which is
/// reported where it was needed first.
class FontLibrary {
public:
    FontLibrary(const JobTree& job, Diagnostics& diagnostics) : m_job(job), m_diagnostics(diagnostics) {}

    const Font& font(const std::string& name, std::string_view path, std::uint32_t line);

private:
    const JobTree& m_job;
    Diagnostics& m_diagnostics;
    std::map<std::string, Font> m_fonts;
};

}  // namespace model::odb
