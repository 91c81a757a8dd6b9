#include "app/clearance/bitmap_text.h"

#include <algorithm>
#include <array>

#include "model/base/ascii.h"

namespace app {

namespace {

constexpr int kColumns = 5;
constexpr int kRows = 7;

/// Rows from the top, of five bits each.
struct Glyph {
    char letter;
    std::array<std::uint8_t, kRows> rows;
};
constexpr Glyph kGlyphs[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}}, {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'D', {30, 17, 17, 17, 17, 17, 30}}, {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 14}}, {'H', {17, 17, 17, 31, 17, 17, 17}}, {'I', {14, 4, 4, 4, 4, 4, 14}},
    {'J', {7, 2, 2, 2, 2, 18, 12}},      {'K', {17, 18, 20, 24, 20, 18, 17}}, {'L', {16, 16, 16, 16, 16, 16, 31}},
    {'M', {17, 27, 21, 21, 17, 17, 17}}, {'N', {17, 25, 21, 21, 19, 17, 17}}, {'O', {14, 17, 17, 17, 17, 17, 14}},
    {'P', {30, 17, 17, 30, 16, 16, 16}}, {'Q', {14, 17, 17, 17, 21, 18, 13}}, {'R', {30, 17, 17, 30, 20, 18, 17}},
    {'S', {15, 16, 16, 14, 1, 1, 30}},   {'T', {31, 4, 4, 4, 4, 4, 4}},       {'U', {17, 17, 17, 17, 17, 17, 14}},
    {'V', {17, 17, 17, 17, 17, 10, 4}},  {'W', {17, 17, 17, 21, 21, 27, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},     {'0', {14, 17, 19, 21, 25, 17, 14}},
    {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {14, 17, 1, 6, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},   {'6', {14, 16, 16, 30, 17, 17, 14}},
    {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 1, 14}},
    {' ', {0, 0, 0, 0, 0, 0, 0}},        {'.', {0, 0, 0, 0, 0, 12, 12}},      {',', {0, 0, 0, 0, 12, 4, 8}},
    {':', {0, 12, 12, 0, 12, 12, 0}},    {'-', {0, 0, 0, 31, 0, 0, 0}},       {'_', {0, 0, 0, 0, 0, 0, 31}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'/', {1, 1, 2, 4, 8, 16, 16}},      {'(', {2, 4, 8, 8, 8, 4, 2}},
    {')', {8, 4, 2, 2, 2, 4, 8}},        {'#', {10, 10, 31, 10, 31, 10, 10}}, {'<', {2, 4, 8, 16, 8, 4, 2}},
    {'>', {8, 4, 2, 1, 2, 4, 8}},        {'m', {0, 0, 26, 21, 21, 21, 21}},   {'u', {0, 0, 17, 17, 17, 19, 13}},
};
constexpr Glyph kUnknown{0, {31, 17, 17, 17, 17, 17, 31}};

const Glyph& glyphOf(char letter) {
    const auto* found = std::ranges::find(kGlyphs, letter, &Glyph::letter);
    if (found == std::end(kGlyphs)) {
        found = std::ranges::find(kGlyphs, base::upperAscii(letter), &Glyph::letter);
    }
    return found != std::end(kGlyphs) ? *found : kUnknown;
}

void fill(render::Image& image, int x, int y, int size, glm::u8vec3 colour) {
    const int right = std::min(x + size, static_cast<int>(image.width));
    const int low = std::min(y + size, static_cast<int>(image.height));
    for (int row = std::max(y, 0); row < low; ++row) {
        for (int column = std::max(x, 0); column < right; ++column) {
            const std::size_t at = (static_cast<std::size_t>(row) * image.width + static_cast<std::size_t>(column)) * 4;
            image.rgba[at] = colour.r;
            image.rgba[at + 1] = colour.g;
            image.rgba[at + 2] = colour.b;
            image.rgba[at + 3] = 255;
        }
    }
}

}  // namespace

void BitmapText::draw(render::Image& image, int x, int y, const std::string& text) const {
    for (const char letter : text) {
        const Glyph& glyph = glyphOf(letter);
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                if ((glyph.rows[static_cast<std::size_t>(row)] >> (kColumns - 1 - column) & 1) != 0) {
                    fill(image, x + column * scale, y + row * scale, scale, colour);
                }
            }
        }
        x += (kColumns + 1) * scale;
    }
}

}  // namespace app
