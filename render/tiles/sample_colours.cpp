#include "render/tiles/sample_colours.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

constexpr glm::vec3 kInsideHole(0.004F);  // as in lib/surface.glsl
constexpr float kBoreShade = 0.4F;        // likewise
constexpr std::uint32_t kMostColours = 255;
constexpr double kWhole = 65535.0;

/// Linear light of an sRGB value of 0 to 255.
double decoded(double value) {
    const double c = value / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint32_t encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    const double srgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::lround(srgb * 255.0));
}

/// By 16-bit linear light.
const std::vector<std::uint8_t>& encodings() {
    static const std::vector<std::uint8_t> kTable = [] {
        std::vector<std::uint8_t> table;
        for (std::uint32_t byte = 0; byte < 256; ++byte) {
            const bool isLast = byte == 255;
            table.resize(isLast ? 65536 : static_cast<std::size_t>(std::ceil(decoded(byte + 0.5) * kWhole)),
                         static_cast<std::uint8_t>(byte));
        }
        return table;
    }();
    return kTable;
}

glm::vec3 lightOf(std::uint32_t pixel) {
    return {decoded(pixel >> 16U & 0xffU), decoded(pixel >> 8U & 0xffU), decoded(pixel & 0xffU)};
}

/// Visible layers from the back, each twice: itself and the insides of its holes.
std::vector<Paint> stackOf(const FramePlan& plan) {
    struct Placed {
        double height;
        Paint paint;
    };
    std::vector<Placed> placed;
    const std::vector<shader::LayerState>& states = plan.upright.states;
    const double stepMm = 1.0 / (std::abs(double{plan.data.clipFromBoard[2][2]}) / double{plan.data.nudgeW});
    const std::uint32_t shift = plan.isFromAbove ? shader::kLayerTopRankShift : shader::kLayerBottomRankShift;
    for (std::uint32_t row = 0; row < states.size(); ++row) {
        const shader::LayerState& state = states[row];
        if ((state.flags & shader::kLayerVisible) == 0) {
            continue;
        }
        const double rank = state.flags >> shift & 0xffU;
        const double height = (plan.isFromAbove ? state.z1 : -state.z0) + 3.0 * rank * stepMm;
        placed.push_back({height, {row, false}});
        placed.push_back({height + double{plan.data.boreProtrusionMm} - stepMm, {row, true}});
    }
    std::ranges::stable_sort(placed, {}, &Placed::height);
    std::vector<Paint> paints;
    std::ranges::transform(placed, std::back_inserter(paints), &Placed::paint);
    return paints;
}

}  // namespace

std::vector<Paint> paintsOf(const FramePlan& plan) {
    std::vector<Paint> paints = stackOf(plan);
    for (Paint& paint : paints) {
        const shader::LayerState& state = plan.upright.states[paint.layer];
        const glm::vec3 colour = paint.isBore ? kInsideHole : glm::vec3(state.colour);
        const bool isTranslucent = (state.flags & shader::kLayerTranslucent) != 0;
        const float alpha = isTranslucent ? state.colour.a : 1.0F;
        paint.light = glm::mix(plan.data.background, colour, plan.data.restStrength) * alpha;
        paint.passed = isTranslucent ? plan.upright.passed[paint.layer] : glm::vec3(0.0F);
    }
    return paints;
}

std::vector<Paint> paintsStandingOut(const FramePlan& plan) {
    std::vector<Paint> paints = stackOf(plan);
    for (Paint& paint : paints) {
        paint.light = glm::vec3(paint.isBore ? kBoreShade : plan.upright.states[paint.layer].colour.a);
    }
    return paints;
}

std::optional<std::uint8_t> SampleColours::idOf(const glm::vec3& linear) {
    const std::uint32_t pixel = 0xff000000U | encoded(linear.r) << 16U | encoded(linear.g) << 8U | encoded(linear.b);
    const auto found = std::ranges::find(m_pixels, pixel);
    const auto id = static_cast<std::size_t>(found - m_pixels.begin());
    if (found == m_pixels.end()) {
        if (m_pixels.size() >= kMostColours) {
            return std::nullopt;
        }
        m_pixels.push_back(pixel);
        const glm::vec3 light = lightOf(pixel);
        const auto whole = [](float part) { return static_cast<std::uint32_t>(std::lround(part * kWhole)); };
        m_light.push_back({whole(light.r), whole(light.g), whole(light.b)});
    }
    return static_cast<std::uint8_t>(id);
}

std::optional<SampleColours> SampleColours::make(const glm::vec3& background, std::span<const Paint> paints,
                                                 std::span<const glm::vec3> over) {
    SampleColours colours;
    (void)colours.idOf(background);
    for (const Paint& paint : paints) {
        std::array<std::uint8_t, 256> after{};
        const std::size_t before = colours.m_pixels.size();
        for (std::size_t id = 0; id < before; ++id) {
            const std::optional<std::uint8_t> made =
                colours.idOf(paint.light + paint.passed * lightOf(colours.m_pixels[id]));
            if (!made) {
                return std::nullopt;
            }
            after[id] = *made;
        }
        colours.m_after.push_back(after);
    }
    for (const glm::vec3& colour : over) {
        const std::optional<std::uint8_t> made = colours.idOf(colour);
        if (!made) {
            return std::nullopt;
        }
        colours.m_over.push_back(*made);
    }
    return colours;
}

std::uint32_t SampleColours::mixed(std::uint32_t samples) const {
    const std::vector<std::uint8_t>& table = encodings();
    std::array<std::uint32_t, 3> sum{2, 2, 2};
    for (std::uint32_t shift = 0; shift < 32; shift += 8) {
        const std::array<std::uint32_t, 3>& light = m_light[samples >> shift & 0xffU];
        sum = {sum[0] + light[0], sum[1] + light[1], sum[2] + light[2]};
    }
    return 0xff000000U | std::uint32_t{table[sum[0] / 4]} << 16U | std::uint32_t{table[sum[1] / 4]} << 8U |
           table[sum[2] / 4];
}

}  // namespace render
