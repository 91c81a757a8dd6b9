#include "model/export/solids/step_text.h"

#include <charconv>
#include <cmath>

namespace model {

namespace {

/// `digits` of `value` behind the point, without zeros at the end.
void putFixed(std::string& text, std::int64_t value, int digits) {
    char buffer[32];
    char* end = buffer + sizeof(buffer);
    char* begin = end;
    const bool isNegative = value < 0;
    std::uint64_t rest = isNegative ? 0U - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    bool isSignificant = false;
    for (int i = 0; i < digits; ++i, rest /= 10) {
        isSignificant = isSignificant || rest % 10 != 0;
        if (isSignificant) {
            *--begin = static_cast<char>('0' + rest % 10);
        }
    }
    *--begin = '.';
    do {
        *--begin = static_cast<char>('0' + rest % 10);
        rest /= 10;
    } while (rest != 0);
    if (isNegative) {
        *--begin = '-';
    }
    text.append(begin, end);
}

/// The next character of UTF-8 at `at`, which moves on; 0xFFFFFFFF if the bytes are none.
char32_t decode(std::string_view utf8, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return i < utf8.size() ? static_cast<unsigned char>(utf8[i]) : 0U; };
    const unsigned first = byte(at);
    const std::size_t length = first < 0x80        ? 1
                               : first >> 5U == 6  ? 2
                               : first >> 4U == 14 ? 3
                               : first >> 3U == 30 ? 4
                                                   : 0;
    constexpr unsigned kMasks[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    char32_t character = first & kMasks[length];
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(at + i) >> 6U != 2) {
            ++at;
            return 0xFFFFFFFF;
        }
        character = character << 6U | (byte(at + i) & 0x3FU);
    }
    at += length == 0 ? 1 : length;
    return length == 0 ? 0xFFFFFFFF : character;
}

void putHex(std::string& text, char32_t value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
        text += "0123456789ABCDEF"[value >> static_cast<unsigned>(shift) & 15U];
    }
}

void putBeyondAscii(std::string& text, char32_t character) {
    const bool isWide = character > 0xFFFF;
    text += isWide ? "\\X4\\" : "\\X2\\";
    putHex(text, character, isWide ? 8 : 4);
    text += "\\X0\\";
}

}  // namespace

StepId StepText::begin() {
    m_text += '#';
    ++m_last;
    char buffer[16];
    m_text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), m_last).ptr);
    m_text += '=';
    return m_last;
}

void StepText::put(StepId id) {
    if (id == 0) {
        m_text += '$';
        return;
    }
    char buffer[16];
    m_text += '#';
    m_text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), id).ptr);
}

void StepText::put(std::span<const StepId> ids) {
    m_text += '(';
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i > 0) {
            m_text += ',';
        }
        put(ids[i]);
    }
    m_text += ')';
}

void StepText::put(Length length) {
    putFixed(m_text, std::llround(length.nm * 100), 8);
}

void StepText::put(Ratio ratio) {
    putFixed(m_text, std::llround(ratio.value * 1e9), 9);
}

StepId StepText::point(base::PointD p, double z) {
    return add("CARTESIAN_POINT('',(", Length{p.x}, ",", Length{p.y}, ",", Length{z}, "))");
}

StepId StepText::direction(double x, double y, double z) {
    return add("DIRECTION('',(", Ratio{x}, ",", Ratio{y}, ",", Ratio{z}, "))");
}

std::string stepString(std::string_view utf8) {
    std::string text = "'";
    for (std::size_t at = 0; at < utf8.size();) {
        const char32_t character = decode(utf8, at);
        if (character == '\'' || character == '\\') {
            text.append(2, static_cast<char>(character));
        } else if (character >= 0x20 && character < 0x7F) {
            text += static_cast<char>(character);
        } else if (character >= 0x80 && character <= 0x10FFFF) {
            putBeyondAscii(text, character);
        } else {
            text += '?';
        }
    }
    return text + "'";
}

}  // namespace model
