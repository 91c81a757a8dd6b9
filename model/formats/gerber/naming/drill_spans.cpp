#include "model/formats/gerber/naming/drill_spans.h"

#include <algorithm>

#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr int kMostLayers = 99;
constexpr int kBottomOfEagle = 16;

/// The digits at the end of a text.
std::string_view digitsAtEnd(std::string_view text) {
    const std::size_t last = text.find_last_not_of(kDigits);
    return text.substr(last == std::string_view::npos ? 0 : last + 1);
}

std::optional<NamedSpan> spanOf(std::string_view first, std::string_view last) {
    NamedSpan span;
    span.first = parseInteger(first).value_or(0);
    span.last = parseInteger(last).value_or(0);
    const bool isSpan = span.first > 0 && span.first < span.last && span.last <= kMostLayers;
    return isSpan ? std::optional(span) : std::nullopt;
}

/// "-1-6" or "_1-6" at the end.
std::optional<NamedSpan> spanOfAllegro(std::string_view stem) {
    const std::string_view last = digitsAtEnd(stem);
    stem.remove_suffix(last.size());
    if (last.empty() || !stem.ends_with('-')) {
        return std::nullopt;
    }
    stem.remove_suffix(1);
    const std::string_view first = digitsAtEnd(stem);
    stem.remove_suffix(first.size());
    const bool isJoined = stem.ends_with('-') || stem.ends_with('_');
    return first.empty() || !isJoined ? std::nullopt : spanOf(first, last);
}

/// Four digits are the ending.
std::optional<NamedSpan> spanOfEagle(std::string_view ending) {
    const bool isNumber = ending.size() == 4 && ending.find_first_not_of(kDigits) == std::string_view::npos;
    std::optional<NamedSpan> span = isNumber ? spanOf(ending.substr(0, 2), ending.substr(2)) : std::nullopt;
    if (!span || span->last > kBottomOfEagle) {
        return std::nullopt;
    }
    span->isOfEagle = true;
    return span;
}

}  // namespace

std::optional<NamedSpan> spanInName(std::string_view name) {
    const std::size_t point = name.find_last_of('.');
    if (point == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<NamedSpan> span = spanOfAllegro(name.substr(0, point));
    return span ? span : spanOfEagle(name.substr(point + 1));
}

}  // namespace model::gerber
