// What colours are to people who lack cones, and how far apart they are then.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace vision {

/// What a colour is with missing cones: Machado, Oliveira and Fernandes 2009, severity 1, on linear sRGB. Rows are r, g
/// and b.
struct Vision {
    const char* name;
    std::array<glm::dvec3, 3> rows;
};
inline constexpr std::array<Vision, 4> kVisions{
    {{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
     {"protanopia",
      {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
     {"deuteranopia",
      {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
     {"tritanopia",
      {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}}};
/// One man in twelve; the last one is one person in thousands.
inline constexpr std::span<const Vision> kCommonVisions = std::span(kVisions).first(3);

inline double linear(double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* with the white of sRGB: distances of 2 to 3 are just seen side by side.
inline glm::dvec3 labOf(const glm::vec3& colour, const Vision& vision) {
    const glm::dvec3 rgb(linear(colour.r), linear(colour.g), linear(colour.b));
    glm::dvec3 seen;
    for (int row = 0; row < 3; ++row) {
        seen[row] = std::clamp(glm::dot(vision.rows[static_cast<std::size_t>(row)], rgb), 0.0, 1.0);
    }
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f(glm::dot(glm::dvec3(0.4124, 0.3576, 0.1805), seen) / 0.95047);
    const double y = f(glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), seen));
    const double z = f(glm::dot(glm::dvec3(0.0193, 0.1192, 0.9505), seen) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

inline double distance(const glm::vec3& a, const glm::vec3& b, const Vision& vision) {
    return glm::distance(labOf(a, vision), labOf(b, vision));
}

}  // namespace vision
