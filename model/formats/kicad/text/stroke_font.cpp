#include "model/formats/kicad/text/stroke_font.h"

#include <algorithm>
#include <charconv>

#include "model/formats/kicad/text/glyph_tables.h"

namespace model::kicad {

namespace {

/// Reads whole numbers from a text; what stands between them is passed over.
class Numbers {
public:
    explicit Numbers(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool hasMore() const { return !m_text.empty(); }
    [[nodiscard]] double next() {
        int value = 0;
        const auto [end, error] = std::from_chars(m_text.data(), m_text.data() + m_text.size(), value);
        m_text.remove_prefix(static_cast<std::size_t>(end - m_text.data()));
        return value;
    }
    /// Passes over what separates two numbers; says whether it ended a line.
    bool skip() {
        const std::size_t count = std::min(m_text.find_first_of("-0123456789"), m_text.size());
        const bool isEnd = m_text.substr(0, count).find_first_of(":;") != std::string_view::npos;
        m_text.remove_prefix(count);
        return isEnd;
    }

private:
    std::string_view m_text;
};

/// Empty where the font has no such character.
std::string_view linesOf(char32_t character) {
    for (const std::span<const GlyphRow> table : {latinGlyphs(), otherGlyphs()}) {
        const auto found = std::ranges::lower_bound(table, character, {}, &GlyphRow::character);
        if (found != table.end() && found->character == character) {
            return found->lines;
        }
    }
    return {};
}

}  // namespace

std::optional<Glyph> glyphOf(char32_t character) {
    const std::string_view lines = linesOf(character);
    if (lines.empty()) {
        return {};
    }
    Numbers numbers(lines);
    Glyph glyph;
    glyph.advance = numbers.next();
    while (numbers.hasMore()) {
        if (numbers.skip()) {
            glyph.lines.emplace_back();
        }
        const double x = numbers.next();
        numbers.skip();
        glyph.lines.back().push_back({x, numbers.next()});
    }
    return glyph;
}

}  // namespace model::kicad
