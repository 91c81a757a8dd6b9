#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/common/font.h"

namespace model::formats {

/// The characters of a UTF-8 text; broken bytes are left out.
[[nodiscard]] std::u32string codePoints(std::string_view utf8);

/// A line of text to draw with a stroke font.
struct TextLine {
    std::string text;          ///< UTF-8
    Nm xSize = 0;              ///< of one character, its space included
    Nm ySize = 0;              ///< of a capital
    double widthFactor = 0.0;  ///< of the font's pens
};

/// A straight stroke in the text's own system: nanometres, the lower left corner of the first character at the origin.
struct TextStroke {
    PointD a;
    PointD b;
    Nm width = 0;
    bool isSquare = false;
    bool isNegative = false;  ///< takes away what the strokes before it have drawn
};

struct TextLayout {
    std::vector<TextStroke> strokes;  ///< character by character
    double length = 0.0;              ///< of the whole text, the space behind its last character included
    std::string problem;              ///< for the diagnostics: characters that the font lacks, variables; else empty
};

/// Strokes scale with the text's sizes, pens do not: their width is the font's (12 mil in the fonts of real jobs) times
/// the text's width factor. A character that the font lacks leaves its space empty. `$$` variables are not filled in.
[[nodiscard]] TextLayout layOut(const TextLine& text, const Font& font);

}  // namespace model::formats
