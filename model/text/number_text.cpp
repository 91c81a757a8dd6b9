#include "model/text/number_text.h"

#include <array>
#include <charconv>
#include <string_view>

namespace model {

void appendNumber(std::string& out, double value, int digits) {
    std::array<char, 400> text{};  // 1e308 has 309 digits before the point
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
    std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
    if (digits > 0) {
        number.remove_suffix(number.size() - 1 - number.find_last_not_of('0'));
        number.remove_suffix(number.ends_with('.') ? 1 : 0);
    }
    out += number == "-0" ? std::string_view("0") : number;
}

void appendSignificant(std::string& out, double value, int digits) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    const std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
    out += number == "-0" ? std::string_view("0") : number;
}

}  // namespace model
