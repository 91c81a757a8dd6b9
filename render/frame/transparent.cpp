#include "render/frame/transparent.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/assert.h"

namespace render {

namespace {

/// What rounding to bytes changes, linear: the largest step between two neighbours.
constexpr double kRounding = 0.009;

double linear(std::uint8_t byte) {
    static const std::array<double, 256> kTable = [] {
        std::array<double, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double c = static_cast<double>(i) / 255.0;
            table[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        }
        return table;
    }();
    return kTable[byte];
}

std::uint8_t encoded(double value) {
    const double c = std::clamp(value, 0.0, 1.0);
    const double sRgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(sRgb * 255.0));
}

/// How much of the background shows through: the channel in which black and white differ most.
double throughOf(const std::uint8_t* black, const std::uint8_t* white) {
    double through = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        through = std::max(through, linear(white[channel]) - linear(black[channel]));
    }
    return through <= kRounding ? 0.0 : std::min(through, 1.0);
}

}  // namespace

Image withoutBackground(const Image& onBlack, const Image& onWhite) {
    ASSERT(onBlack.rgba.size() == onWhite.rgba.size());
    Image image = onBlack;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        const double alpha = 1.0 - throughOf(&onBlack.rgba[i], &onWhite.rgba[i]);
        for (std::size_t channel = i; channel < i + 3; ++channel) {
            image.rgba[channel] = alpha > 0.0 ? encoded(linear(onBlack.rgba[channel]) / alpha) : std::uint8_t{0};
        }
        image.rgba[i + 3] = static_cast<std::uint8_t>(std::lround(alpha * 255.0));
    }
    return image;
}

}  // namespace render
