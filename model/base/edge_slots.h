#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/base/point.h"

namespace base {

/// Finds edges that run between the same points, there or back: a hash table of their rows, which the caller compares.
class EdgeSlots {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;

    /// Empties it and makes room for so many edges.
    void reset(std::size_t edges) { m_slots.assign(std::bit_ceil(2 * edges), kNone); }

    /// Row of the first edge kept between these points, in whichever direction, that `matches(row)`; kNone where there
    /// is none, and then `row` is kept. `matches` is asked of a few others too.
    template <class Matches>
    std::uint32_t findOrKeep(Point a, Point b, std::uint32_t row, const Matches& matches) {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = hash(a, b) & mask;
        for (; m_slots[slot] != kNone; slot = (slot + 1) & mask) {
            if (matches(m_slots[slot])) {
                return m_slots[slot];
            }
        }
        m_slots[slot] = row;
        return kNone;
    }

private:
    /// The same for both directions.
    [[nodiscard]] static std::uint64_t hash(Point a, Point b) {
        const auto bits = [](Point p) {
            return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32U | static_cast<std::uint32_t>(p.y);
        };
        std::uint64_t key = bits(a) * 0x9E3779B97F4A7C15U + bits(b) * 0x9E3779B97F4A7C15U;
        key ^= key >> 32U;
        key *= 0xD6E8FEB86659FD93U;
        return key ^ key >> 32U;
    }

    std::vector<std::uint32_t> m_slots;
};

}  // namespace base
