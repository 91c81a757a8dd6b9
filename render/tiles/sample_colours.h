#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/culling/frame_plan.h"

namespace render {

/// What covers samples in one colour: the solid parts of a layer, or the insides of its holes.
struct Paint {
    std::uint32_t layer = 0;
    bool isBore = false;
    glm::vec3 light{0.0F};   ///< linear, multiplied by its opacity
    glm::vec3 passed{0.0F};  ///< how much of what lies beneath shows through; 0: it is opaque
    bool operator==(const Paint&) const = default;
    [[nodiscard]] bool isOpaque() const { return passed == glm::vec3(0.0F); }
};

/// What a flat frame paints of its board, from the back: by height, then by the rank of the face that is seen, and the
/// insides of holes as far above their layer as they protrude (lib/surface.glsl).
[[nodiscard]] std::vector<Paint> paintsOf(const FramePlan& plan);
/// The layers of a plan for Subject::StandingOut from the back, with insides of holes as paints of their own; their
/// light is how bright they are for what they are (1, or less in holes).
[[nodiscard]] std::vector<Paint> paintsStandingOut(const FramePlan& plan);

/// The colours that samples may get, as few as there are, and what each paint makes of each: a picture is painted with
/// bytes. Colours are rounded to 8 bits of sRGB after every paint, as on the device.
class SampleColours {
public:
    /// `over` are opaque colours (linear) that follow all paints; none: there are too many colours for a byte.
    [[nodiscard]] static std::optional<SampleColours> make(const glm::vec3& background, std::span<const Paint> paints,
                                                           std::span<const glm::vec3> over);

    static constexpr std::uint8_t kBackground = 0;
    /// By paint: the colour that takes the place of each.
    [[nodiscard]] const std::vector<std::array<std::uint8_t, 256>>& after() const { return m_after; }
    [[nodiscard]] std::span<const std::uint8_t> over() const { return m_over; }
    /// 0xffRRGGBB of a pixel whose four samples have these colours, a byte each.
    [[nodiscard]] std::uint32_t pixel(std::uint32_t samples) const {
        const std::uint32_t first = samples & 0xffU;
        return first * 0x01010101U == samples ? m_pixels[first] : mixed(samples);
    }

private:
    [[nodiscard]] std::uint32_t mixed(std::uint32_t samples) const;
    [[nodiscard]] std::optional<std::uint8_t> idOf(const glm::vec3& linear);

    std::vector<std::uint32_t> m_pixels;
    std::vector<std::array<std::uint32_t, 3>> m_light;  ///< linear, 16 bits
    std::vector<std::array<std::uint8_t, 256>> m_after;
    std::vector<std::uint8_t> m_over;
};

}  // namespace render
