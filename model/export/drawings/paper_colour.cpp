#include "model/export/drawings/paper_colour.h"

#include <array>
#include <cmath>

namespace model {

namespace {

constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};
/// Of a colour with a contrast of 3 to white, whose luminance is 1: (1 + 0.05) / (l + 0.05) = 3.
constexpr double kMostLuminance = 0.3;

double toLight(double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double fromLight(double light) {
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

}  // namespace

std::uint32_t onPaper(std::uint32_t colour) {
    constexpr std::array kShifts = {16U, 8U, 0U};
    std::array<double, 3> light{};
    double luminance = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        light[i] = toLight(static_cast<double>(colour >> kShifts[i] & 0xFFU) / 255.0);
        luminance += kWeights[i] * light[i];
    }
    if (luminance <= kMostLuminance) {
        return colour;
    }
    std::uint32_t darker = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double part = fromLight(light[i] * kMostLuminance / luminance);
        darker |= static_cast<std::uint32_t>(part * 255.0) << kShifts[i];  // rounded to what is darker
    }
    return darker;
}

}  // namespace model
