#pragma once

#include <algorithm>
#include <string_view>

namespace base {

/// Letters of ASCII in small; all other bytes as they are, whatever the locale.
[[nodiscard]] constexpr char lowerAscii(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Are two texts the same but for the case of ASCII letters?
[[nodiscard]] constexpr bool equalsIgnoringCase(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lowerAscii, lowerAscii);
}

}  // namespace base
