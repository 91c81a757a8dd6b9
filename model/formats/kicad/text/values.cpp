#include "model/formats/kicad/text/values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "model/base/ascii.h"

namespace model::kicad {

namespace {

constexpr double kFarthest = 1e12;
constexpr int kMostDigits = 15;

/// The plain form, at most six digits behind the point: nearly all of a board.
std::optional<double> plainLength(std::string_view word) {
    std::size_t at = !word.empty() && word[0] == '-' ? 1 : 0;
    const bool isNegative = at == 1;
    std::int64_t value = 0;
    int digits = 0;
    int behind = -1;
    for (; at < word.size(); ++at) {
        if (word[at] == '.' && behind < 0) {
            behind = 0;
            continue;
        }
        if (!base::isDigit(word[at]) || behind == 6 || digits == kMostDigits - 6) {
            return {};
        }
        value = value * 10 + (word[at] - '0');
        ++digits;
        behind += behind >= 0 ? 1 : 0;
    }
    constexpr std::array<std::int64_t, 7> kScale = {1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
    value *= kScale[static_cast<std::size_t>(std::max(behind, 0))];
    return digits > 0 ? std::optional(static_cast<double>(isNegative ? -value : value)) : std::nullopt;
}

}  // namespace

std::optional<double> numberOf(std::string_view word) {
    double value = 0.0;
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool isNumber = error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value);
    return isNumber ? std::optional(value) : std::nullopt;
}

std::optional<double> lengthOf(std::string_view word) {
    if (const std::optional<double> plain = plainLength(word)) {
        return plain;
    }
    const std::optional<double> mm = numberOf(word);
    return mm && std::abs(*mm) * 1e6 <= kFarthest ? std::optional(std::round(*mm * 1e6)) : std::nullopt;
}

double length(const Item& list, std::string_view head, double otherwise) {
    return lengthOf(list.find(head).word(1)).value_or(otherwise);
}

double number(const Item& list, std::string_view head, double otherwise) {
    return numberOf(list.find(head).word(1)).value_or(otherwise);
}

std::optional<base::PointD> pointOf(const Item& list) {
    auto item = list.begin();
    std::array<double, 2> values{};
    for (double& value : values) {
        if (item == list.end() || ++item == list.end() || (*item).isList()) {
            return {};
        }
        const std::optional<double> length = lengthOf((*item).source());
        if (!length) {
            return {};
        }
        value = *length;
    }
    return base::PointD{values[0], values[1] == 0.0 ? 0.0 : -values[1]};
}

std::optional<base::PointD> point(const Item& list, std::string_view head) {
    const Item found = list.find(head);
    return found.isThere() ? pointOf(found) : std::nullopt;
}

std::optional<base::PointD> size(const Item& list, std::string_view head) {
    const Item found = list.find(head);
    const std::optional<double> x = lengthOf(found.word(1));
    return x ? std::optional(base::PointD{*x, lengthOf(found.word(2)).value_or(*x)}) : std::nullopt;
}

std::string nameOf(std::string_view escaped) {
    constexpr std::array<std::pair<std::string_view, char>, 14> kEscapes = {{{"{slash}", '/'},
                                                                             {"{backslash}", '\\'},
                                                                             {"{lt}", '<'},
                                                                             {"{gt}", '>'},
                                                                             {"{colon}", ':'},
                                                                             {"{dblquote}", '"'},
                                                                             {"{quote}", '\''},
                                                                             {"{brace}", '{'},
                                                                             {"{space}", ' '},
                                                                             {"{tab}", '\t'},
                                                                             {"{return}", '\n'},
                                                                             {"{bar}", '|'},
                                                                             {"{comma}", ','},
                                                                             {"{dollar}", '$'}}};
    constexpr std::string_view kMarks = "$~^_";  // before a brace: a variable, a bar, raised, lowered
    std::string name;
    for (std::size_t i = 0; i < escaped.size();) {
        const bool isMark = i > 0 && kMarks.find(escaped[i - 1]) != std::string_view::npos;
        std::size_t taken = 0;
        for (const auto& [word, character] : kEscapes) {
            if (!isMark && escaped[i] == '{' && escaped.substr(i).starts_with(word)) {
                name += character;
                taken = word.size();
                break;
            }
        }
        if (taken == 0) {
            name += escaped[i];
            taken = 1;
        }
        i += taken;
    }
    return name;
}

}  // namespace model::kicad
