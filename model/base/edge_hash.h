#pragma once

#include <cstdint>

#include "model/base/point.h"

namespace base {

/// Of an edge between two points: the same for both directions.
[[nodiscard]] inline std::uint64_t edgeHash(Point a, Point b) {
    const auto bits = [](Point p) {
        return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32U | static_cast<std::uint32_t>(p.y);
    };
    std::uint64_t key = bits(a) * 0x9E3779B97F4A7C15U + bits(b) * 0x9E3779B97F4A7C15U;
    key ^= key >> 32U;
    key *= 0xD6E8FEB86659FD93U;
    return key ^ key >> 32U;
}

}  // namespace base
