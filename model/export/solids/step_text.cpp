#include "model/export/solids/step_text.h"

#include <charconv>

namespace model {

namespace {

/// The longest of what putFixed() and putNumber() write.
constexpr std::size_t kMostDigits = 24;

/// `Digits` of `value` behind the point, without zeros at the end.
template <int Digits>
char* putFixed(char* at, std::int64_t value) {
    static constexpr std::uint64_t kOne = Digits == 8 ? 100'000'000U : 1'000'000'000U;
    if (value < 0) {
        *at++ = '-';
    }
    const std::uint64_t size = value < 0 ? 0U - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    at = std::to_chars(at, at + kMostDigits, size / kOne).ptr;
    *at++ = '.';
    auto rest = static_cast<std::uint32_t>(size % kOne);
    if (rest == 0) {
        return at;
    }
    int digits = Digits;
    for (; rest % 10 == 0; rest /= 10) {
        --digits;
    }
    for (int i = digits; i-- > 0; rest /= 10) {
        at[i] = static_cast<char>('0' + rest % 10);
    }
    return at + digits;
}

std::int64_t rounded(double value) {
    return static_cast<std::int64_t>(value < 0 ? value - 0.5 : value + 0.5);
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
    put(++m_last);
    put("=");
    return m_last;
}

void StepText::put(StepId id) {
    if (id == 0) {
        return put("$");
    }
    char* at = room(kMostDigits);
    *at = '#';
    end(std::to_chars(at + 1, at + kMostDigits, id).ptr);
}

void StepText::put(Length length) {
    end(putFixed<8>(room(kMostDigits), rounded(length.nm * 100)));
}

void StepText::put(Ratio ratio) {
    end(putFixed<9>(room(kMostDigits), rounded(ratio.value * 1e9)));
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
