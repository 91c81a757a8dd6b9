#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/odb/features/text_records.h"
#include "model/formats/odb/symbols/font.h"

namespace model::odb {

/// The characters of a UTF-8 text; broken bytes are left out.
[[nodiscard]] std::u32string codePoints(std::string_view utf8);

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
/// the text's width factor. A character that the font lacks leaves its place empty. `$$` variables are not filled in.
[[nodiscard]] TextLayout layOut(const TextRecord& text, const Font& font);

}  // namespace model::odb
