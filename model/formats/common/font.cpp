#include "model/formats/common/font.h"

#include <algorithm>

namespace model::formats {

namespace {

bool isCapitalOrDigit(char32_t c) {
    return (c >= U'A' && c <= U'Z') || (c >= U'0' && c <= U'9');
}

}  // namespace

void Font::addStroke(char32_t character, const FontStroke& stroke) {
    m_glyphs[character].push_back(stroke);
    if (!isCapitalOrDigit(character)) {
        return;
    }
    const PointD low = {std::min(stroke.a.x, stroke.b.x), std::min(stroke.a.y, stroke.b.y)};
    m_corner = m_hasCorner ? PointD{std::min(m_corner.x, low.x), std::min(m_corner.y, low.y)} : low;
    m_hasCorner = true;
}

std::vector<FontStroke> Font::strokes(char32_t character) const {
    const auto glyph = m_glyphs.find(character);
    std::vector<FontStroke> strokes = glyph == m_glyphs.end() ? std::vector<FontStroke>{} : glyph->second;
    for (FontStroke& stroke : strokes) {
        stroke.a = {stroke.a.x - m_corner.x, stroke.a.y - m_corner.y};
        stroke.b = {stroke.b.x - m_corner.x, stroke.b.y - m_corner.y};
    }
    return strokes;
}

}  // namespace model::formats
