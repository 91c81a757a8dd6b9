#include "render/scene/colour_ramp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

namespace {

/// Lightness, chroma and hue of both ends in Oklab, in which equal steps appear equal.
constexpr float kLightest = 0.93F;
constexpr float kDarkest = 0.38F;
constexpr float kChroma = 0.145F;
constexpr float kFirstHueDeg = 105.0F;
constexpr float kLastHueDeg = 300.0F;

float companded(float linear) {
    const float limited = std::clamp(linear, 0.0F, 1.0F);
    return limited <= 0.0031308F ? 12.92F * limited : 1.055F * std::pow(limited, 1.0F / 2.4F) - 0.055F;
}

/// Oklab to sRGB; what a screen cannot show is limited to what it can.
glm::vec3 fromOklab(float lightness, float a, float b) {
    const float l = lightness + 0.3963377774F * a + 0.2158037573F * b;
    const float m = lightness - 0.1055613458F * a - 0.0638541728F * b;
    const float s = lightness - 0.0894841775F * a - 1.2914855480F * b;
    const glm::vec3 cones{l * l * l, m * m * m, s * s * s};
    return {companded(glm::dot(cones, {4.0767416621F, -3.3077115913F, 0.2309699292F})),
            companded(glm::dot(cones, {-1.2684380046F, 2.6097574011F, -0.3413193965F})),
            companded(glm::dot(cones, {-0.0041960863F, -0.7034186147F, 1.7076147010F}))};
}

}  // namespace

glm::vec3 rampColour(float value) {
    const float t = std::clamp(value, 0.0F, 1.0F);
    const float hue = std::lerp(kFirstHueDeg, kLastHueDeg, t) * std::numbers::pi_v<float> / 180.0F;
    return fromOklab(std::lerp(kLightest, kDarkest, t), kChroma * std::cos(hue), kChroma * std::sin(hue));
}

}  // namespace render
