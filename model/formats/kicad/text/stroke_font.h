#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/base/point.h"

namespace model::kicad {

/// A character of the stroke font that KiCad draws with, on the font's grid: y from the base line up.
struct Glyph {
    double advance = 0.0;  ///< to the next character
    std::vector<std::vector<base::PointD>> lines;
};

/// How high capitals are on the grid: a text of 1 mm has 21 steps of its grid in a millimetre.
inline constexpr double kGlyphGrid = 21.0;

/// None where the font has no such character: Chinese, Japanese, Korean and others (glyph_tables.h).
[[nodiscard]] std::optional<Glyph> glyphOf(char32_t character);

}  // namespace model::kicad
