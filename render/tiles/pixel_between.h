#pragma once

#include <cstdint>

namespace render {

/// The mean of two pixels, of which `part` of 256 is the second one's; each of four channels by itself.
constexpr std::uint32_t pixelBetween(std::uint32_t a, std::uint32_t b, std::uint32_t part) {
    constexpr std::uint32_t kEven = 0x00ff00ffU;  // two channels at a time
    const std::uint32_t even = ((a & kEven) * (256 - part) + (b & kEven) * part) >> 8U & kEven;
    const std::uint32_t odd = ((a >> 8U & kEven) * (256 - part) + (b >> 8U & kEven) * part) & ~kEven;
    return even | odd;
}

}  // namespace render
