#include "model/formats/ipc2581/xml/xml_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "model/text/utf8.h"

namespace model::ipc2581 {

namespace {

constexpr std::size_t kLongestEntity = 12;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// The character that `&name;` stands for.
std::optional<std::uint32_t> characterOf(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, char>, 5> kNames = {
        {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
    for (const auto& [known, character] : kNames) {
        if (known == name) {
            return static_cast<std::uint32_t>(character);
        }
    }
    if (!name.starts_with('#')) {
        return std::nullopt;
    }
    const bool isHex = name.starts_with("#x");
    name.remove_prefix(isHex ? 2 : 1);
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number, isHex ? 16 : 10);
    const bool isCharacter = number > 0 && number < 0x110000 && (number < 0xD800 || number > 0xDFFF);
    return error == std::errc() && end == name.data() + name.size() && isCharacter ? std::optional(number)
                                                                                   : std::nullopt;
}

}  // namespace

std::optional<double> realOf(std::string_view value) {
    value = trimmed(value);
    value.remove_prefix(value.starts_with('+') ? 1 : 0);
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool isWhole = error == std::errc() && end == value.data() + value.size() && std::isfinite(number);
    return isWhole ? std::optional(number) : std::nullopt;
}

bool isTrue(std::string_view value) {
    value = trimmed(value);
    return value == "1" || (value.size() == 4 && (value[0] | 0x20) == 't' && (value[1] | 0x20) == 'r' &&
                            (value[2] | 0x20) == 'u' && (value[3] | 0x20) == 'e');
}

std::string textOf(std::string_view value) {
    std::string text;
    text.reserve(value.size());
    while (!value.empty()) {
        const std::size_t end = value[0] == '&' ? value.substr(0, kLongestEntity).find(';') : std::string_view::npos;
        const auto character = end != std::string_view::npos ? characterOf(value.substr(1, end - 1)) : std::nullopt;
        if (character) {
            appendUtf8(text, *character);
            value.remove_prefix(end + 1);
            continue;
        }
        moveCharacter(value, text);
    }
    return text;
}

}  // namespace model::ipc2581
