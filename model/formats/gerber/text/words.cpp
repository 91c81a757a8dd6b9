#include "model/formats/gerber/text/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "model/base/units.h"

namespace model::gerber {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

bool isSame(char a, char b) {
    return base::lowerAscii(a) == base::lowerAscii(b);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::optional<double> takeReal(std::string_view& text) {
    std::string_view rest = text;
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (rest.starts_with('+')) {
        rest.remove_prefix(1);
    }
    double value = 0.0;
    const std::from_chars_result result =
        std::from_chars(rest.data(), rest.data() + rest.size(), value, std::chars_format::fixed);
    if (result.ec != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    text = rest.substr(static_cast<std::size_t>(result.ptr - rest.data()));
    return value;
}

std::optional<double> parseReal(std::string_view text) {
    const std::optional<double> value = takeReal(text);
    return value && trimmed(text).empty() ? value : std::nullopt;
}

std::optional<int> parseInteger(std::string_view text) {
    text = trimmed(text);
    int value = 0;
    const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() && result.ptr == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

bool holds(std::string_view text, std::string_view words) {
    return std::search(text.begin(), text.end(), words.begin(), words.end(), isSame) != text.end();
}

std::optional<base::Nm> toNm(double nanometres) {
    const double rounded = std::nearbyint(nanometres);
    return std::abs(rounded) <= base::kMaxCoordinate ? std::optional(static_cast<base::Nm>(rounded)) : std::nullopt;
}

std::string shortNumber(double value) {
    std::string text(32, '\0');
    const std::to_chars_result result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    text.resize(static_cast<std::size_t>(result.ptr - text.data()));
    return text;
}

bool Lines::next() {
    if (m_rest.empty()) {
        return false;
    }
    const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
    m_line = m_rest.substr(0, end);
    m_rest.remove_prefix(end);
    m_rest.remove_prefix(m_rest.starts_with("\r\n") ? 2 : m_rest.empty() ? 0 : 1);
    ++m_number;
    return true;
}

}  // namespace model::gerber
