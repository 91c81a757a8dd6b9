#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "model/base/radix_sort.h"

namespace render {

/// Morton order: locations close together have keys close together. Its cells are square, also in a long box. Keys are
/// below 2^22, which sortRows takes two passes for.
class MortonCurve {
public:
    MortonCurve() = default;
    /// Over the box from `low` to `high`.
    MortonCurve(glm::vec2 low, glm::vec2 high)
        : m_low(low), m_scale(kCells / std::max({high.x - low.x, high.y - low.y, 1e-6F})) {}

    [[nodiscard]] std::uint32_t key(glm::vec2 location) const {
        const glm::vec2 cell = glm::clamp((location - m_low) * m_scale, 0.0F, kCells);
        return spread(static_cast<std::uint32_t>(cell.x)) | (spread(static_cast<std::uint32_t>(cell.y)) << 1U);
    }

private:
    static constexpr float kCells = 2047.0F;

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

/// Brings rising rows into the order of their keys, which `keyOf(row)` gives; equal keys stay in order.
template <class KeyOf>
void sortRows(std::span<std::uint32_t> rows, const KeyOf& keyOf) {
    const auto words = std::make_unique_for_overwrite<std::uint64_t[]>(2 * rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        words[i] = std::uint64_t{keyOf(rows[i])} << 32U | rows[i];
    }
    const std::uint64_t* sorted = base::sortByKey(words.get(), words.get() + rows.size(), rows.size());
    std::transform(sorted, sorted + rows.size(), rows.begin(),
                   [](std::uint64_t word) { return static_cast<std::uint32_t>(word); });
}

}  // namespace render
