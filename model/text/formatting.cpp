#include "model/text/formatting.h"

#include <charconv>
#include <string_view>

#include "model/text/utf8.h"

namespace model {

std::string xmlText(const std::string& text) {
    std::string out;
    for (std::string_view rest = text; !rest.empty();) {
        const Character first = firstCharacter(rest);
        const std::string_view bytes = rest.substr(0, first.isSound ? first.bytes : 1);
        rest.remove_prefix(bytes.size());
        if (!first.isSound || first.code < 0x20) {
            out += first.isSound ? ' ' : '?';
        } else {
            out += bytes == "<" ? "&lt;" : bytes == "&" ? "&amp;" : bytes == "\"" ? "&quot;" : bytes;
        }
    }
    return out;
}

std::string svgStart(double width, double height) {
    return formatted(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"%.0f\" height=\"%.0f\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
        width, height);
}

std::string svgText(double x, double y, const std::string& text, const char* style) {
    return formatted("<text x=\"%.1f\" y=\"%.1f\"%s>", x, y, style) + xmlText(text) + "</text>\n";
}

std::string joined(std::span<const std::string> texts, const char* separator) {
    std::string all;
    for (const std::string& text : texts) {
        all += (all.empty() ? "" : separator) + text;
    }
    return all;
}

std::string lengthText(base::Nm length) {
    return length < 1'000'000 ? formatted("%.5g µm", length / base::kNmPerUm)
                              : formatted("%.5g mm", base::toMm(length));
}

std::string fixedText(double value, int digits) {
    char text[400];  // 1e308 has 309 digits before the point
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr;
    const std::string_view all(text, static_cast<std::size_t>(end - text));
    const bool isNothing = all.find_first_not_of("-0.") == std::string_view::npos;
    return std::string(all.substr(isNothing && all.front() == '-' ? 1 : 0));
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

}  // namespace model
