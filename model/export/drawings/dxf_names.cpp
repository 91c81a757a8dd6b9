#include "model/export/drawings/dxf_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "model/base/ascii.h"
#include "model/text/formatting.h"
#include "model/text/utf8.h"

namespace model {

namespace {

constexpr std::string_view kForbidden = "<>/\\\":;?*|=`,";

/// Without what is in `forbidden`, and without control characters.
std::string escaped(std::string_view text, std::string_view forbidden) {
    std::string out;
    while (!text.empty()) {
        const auto [code, bytes, isSound] = firstCharacter(text);
        if (!isSound || code < 0x20U || code == 0x7FU || code > 0xFFFFU) {
            out += '_';
        } else if (code < 0x80U) {
            out += forbidden.find(static_cast<char>(code)) == std::string_view::npos ? static_cast<char>(code) : '_';
        } else {
            out += formatted("\\U+%04X", code);
        }
        text.remove_prefix(bytes);
    }
    return out;
}

std::string allowed(std::string_view name) {
    const std::string out = escaped(name, kForbidden);
    return out.empty() ? "_" : out;
}

using Rgb = std::array<int, 3>;

/// The table as AutoCAD makes it up: nine colours by name, 24 hues in five strengths, each full and pale, six greys.
Rgb tableColour(int number) {
    constexpr std::array<Rgb, 9> kNamed{{{255, 0, 0},
                                         {255, 255, 0},
                                         {0, 255, 0},
                                         {0, 255, 255},
                                         {0, 0, 255},
                                         {255, 0, 255},
                                         {255, 255, 255},
                                         {128, 128, 128},
                                         {192, 192, 192}}};
    constexpr std::array<int, 5> kStrengths{255, 165, 127, 76, 38};
    constexpr std::array<int, 6> kGreys{51, 80, 105, 130, 190, 255};
    if (number < 10) {
        return kNamed[static_cast<std::size_t>(number) - 1];
    }
    if (number >= 250) {
        const int grey = kGreys[static_cast<std::size_t>(number) - 250];
        return {grey, grey, grey};
    }
    const int strength = kStrengths[static_cast<std::size_t>(number % 10 / 2)];
    const double pale = number % 2 == 1 ? 0.5 : 0.0;
    Rgb rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        // Red is strongest at hue 0, green at 8, blue at 16 of 24, each falling off over the next eight.
        const int steps = std::abs((number / 10 - 1 - 8 * static_cast<int>(i) + 36) % 24 - 12);
        const double full = std::clamp((8.0 - steps) / 4.0, 0.0, 1.0);
        rgb[i] = static_cast<int>(std::lround(strength * (pale + full * (1.0 - pale))));
    }
    return rgb;
}

}  // namespace

std::string DxfNames::unique(std::string_view name) {
    const std::string wanted = allowed(name);
    std::string given = wanted;
    for (int i = 2; !m_taken.insert(base::lowerCase(given)).second; ++i) {
        given = wanted + '_' + std::to_string(i);
    }
    return given;
}

std::string dxfText(std::string_view utf8) {
    return escaped(utf8, {});
}

int dxfColour(std::uint32_t rgb) {
    const Rgb wanted{static_cast<int>(rgb >> 16U & 0xFFU), static_cast<int>(rgb >> 8U & 0xFFU),
                     static_cast<int>(rgb & 0xFFU)};
    int nearest = 7;
    int least = std::numeric_limits<int>::max();
    for (int number = 1; number <= 255; ++number) {
        const Rgb colour = tableColour(number);
        int squared = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            squared += (colour[i] - wanted[i]) * (colour[i] - wanted[i]);
        }
        if (squared < least) {
            least = squared;
            nearest = number;
        }
    }
    return nearest;
}

}  // namespace model
