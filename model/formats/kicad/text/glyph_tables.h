#pragma once

#include <span>
#include <string_view>

namespace model::kicad {

/// A character of KiCad's stroke font: how far it is to the next one, then the points of its lines on the grid, which
/// semicolons end: "10: 5,21 5,7; 5,2 5,0". Where they come from: decision 256.
struct GlyphRow {
    char32_t character = 0;
    std::string_view lines;
};

// Both by character.
/// ASCII and the letters and signs of Latin alphabets, up to U+017F.
[[nodiscard]] std::span<const GlyphRow> latinGlyphs();
/// Greek, Cyrillic, arrows, signs of mathematics and of the trade.
[[nodiscard]] std::span<const GlyphRow> otherGlyphs();

}  // namespace model::kicad
