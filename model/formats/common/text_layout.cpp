#include "model/formats/common/text_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace model::formats {

namespace {

constexpr double kMaxPen = base::kMaxCoordinate / 100.0;
/// Half of the coordinate range, so that a text stays within 32 bits wherever it lies.
constexpr double kMaxExtent = base::kMaxCoordinate / 2.0;

std::string problemOf(const TextLine& text, const Font& font, const std::u32string& characters) {
    const auto missing =
        std::ranges::find_if(characters, [&](char32_t c) { return c != U' ' && !font.has(c); }) - characters.begin();
    if (missing < std::ssize(characters)) {
        return "the font has no character number " +
               std::to_string(static_cast<std::uint32_t>(characters[static_cast<std::size_t>(missing)])) +
               " for text '" + text.text + "'; its space stays empty";
    }
    const bool hasVariable = text.text.find("$$") != std::string::npos;
    return hasVariable ? "text '" + text.text + "' holds a variable that is filled in at output; drawn as written" : "";
}

/// Whatever units a font counts in.
bool isWithinRange(const TextLayout& layout) {
    const auto isNear = [](PointD p) { return std::abs(p.x) <= kMaxExtent && std::abs(p.y) <= kMaxExtent; };
    return layout.length <= kMaxExtent && std::ranges::all_of(layout.strokes, [&](const TextStroke& stroke) {
               return isNear(stroke.a) && isNear(stroke.b);
           });
}

}  // namespace

std::u32string codePoints(std::string_view utf8) {
    std::u32string points;
    std::size_t open = 0;  // continuation bytes still to come
    for (const char c : utf8) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) == 0x80U) {
            if (open > 0) {
                points.back() = points.back() << 6U | (byte & 0x3FU);
                --open;
            }
            continue;
        }
        const auto lead = static_cast<std::size_t>(std::countl_one(byte));
        open = lead >= 2 ? lead - 1 : 0;
        points.push_back(open > 0 ? byte & (0x7FU >> lead) : byte);
    }
    return points;
}

TextLayout layOut(const TextLine& text, const Font& font) {
    TextLayout layout;
    const std::u32string characters = codePoints(text.text);
    const double scaleX = text.xSize / font.xSize();
    const double scaleY = text.ySize / font.ySize();
    layout.problem = problemOf(text, font, characters);
    for (const char32_t character : characters) {
        for (const FontStroke& stroke : font.strokes(character)) {
            const double pen = stroke.width * base::kNmPerInch * text.widthFactor;
            layout.strokes.push_back({{layout.length + stroke.a.x * scaleX, stroke.a.y * scaleY},
                                      {layout.length + stroke.b.x * scaleX, stroke.b.y * scaleY},
                                      static_cast<Nm>(std::llround(std::clamp(pen, 0.0, kMaxPen))),
                                      stroke.isSquare,
                                      stroke.isNegative});
        }
        layout.length += font.advance() * scaleX;
    }
    if (!isWithinRange(layout)) {
        layout.strokes.clear();
        layout.problem = "the text is larger than half a metre; it draws nothing";
    }
    return layout;
}

}  // namespace model::formats
