#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "model/base/radix_sort.h"

namespace render {

/// Morton order: locations close together have keys close together. Its cells are square, also in a long box.
class MortonCurve {
public:
    MortonCurve() = default;
    /// Over the box from `low` to `high`.
    MortonCurve(glm::vec2 low, glm::vec2 high)
        : m_low(low), m_scale(65535.0F / std::max({high.x - low.x, high.y - low.y, 1e-6F})) {}

    [[nodiscard]] std::uint32_t key(glm::vec2 location) const {
        const glm::vec2 cell = glm::clamp((location - m_low) * m_scale, 0.0F, 65535.0F);
        return spread(static_cast<std::uint32_t>(cell.x)) | (spread(static_cast<std::uint32_t>(cell.y)) << 1U);
    }

private:
    static std::uint32_t spread(std::uint32_t v) {
        v &= 0xffffU;
        v = (v | (v << 8U)) & 0x00ff00ffU;
        v = (v | (v << 4U)) & 0x0f0f0f0fU;
        v = (v | (v << 2U)) & 0x33333333U;
        return (v | (v << 1U)) & 0x55555555U;
    }

    glm::vec2 m_low{0.0F};
    float m_scale = 1.0F;
};

/// Rows in the order of their keys; equal keys stay in order.
[[nodiscard]] inline std::vector<std::uint32_t> rowsByKey(const std::vector<std::uint32_t>& keys) {
    std::vector<std::uint64_t> words(2 * keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        words[i] = std::uint64_t{keys[i]} << 32U | i;
    }
    const std::uint64_t* sorted = base::sortByKey(words.data(), words.data() + keys.size(), keys.size());
    std::vector<std::uint32_t> rows(keys.size());
    std::transform(sorted, sorted + keys.size(), rows.begin(),
                   [](std::uint64_t word) { return static_cast<std::uint32_t>(word); });
    return rows;
}

}  // namespace render
