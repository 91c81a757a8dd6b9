#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "model/base/units.h"

/// Words and numbers as files for others want them.
namespace model {

/// Text as XML takes it: no markup, no control characters, and "?" for bytes that are no UTF-8.
[[nodiscard]] std::string xmlText(const std::string& text);
/// A cell of a comma separated table (RFC 4180), in quotes where it needs them.
[[nodiscard]] std::string csvField(const std::string& text);
/// Begins a drawing of this size in pixels, on white; "</svg>" is to end it.
[[nodiscard]] std::string svgStart(double width, double height);
/// "<text>" of SVG; `style` is more attributes with a space before each.
[[nodiscard]] std::string svgText(double x, double y, const std::string& text, const char* style = "");
/// "a, b, c"
[[nodiscard]] std::string joined(std::span<const std::string> texts, const char* separator = ", ");
/// "35 µm" below a millimetre, "1.6 mm" from there.
[[nodiscard]] std::string lengthText(base::Nm length);

/// A number with so many digits (20 at most) behind a point, whatever the locale; what rounds to nothing has no sign.
[[nodiscard]] std::string fixedText(double value, int digits);

/// As printf has it, up to 511 bytes.
template <class... Values>
[[nodiscard]] std::string formatted(const char* pattern, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

}  // namespace model
