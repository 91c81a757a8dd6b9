#pragma once

#include <cstdint>
#include <random>

namespace soak {

/// Numbers that follow from a seed alone: the same on every machine and with every library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : m_engine(seed) {}

    [[nodiscard]] std::uint64_t next() { return m_engine(); }
    /// 0 to `count` - 1; 0 where there is nothing to choose from.
    [[nodiscard]] std::size_t below(std::size_t count) {
        const std::uint64_t drawn = m_engine();
        return count == 0 ? 0 : static_cast<std::size_t>(drawn % count);
    }
    /// `from` to `to`, both included.
    [[nodiscard]] int between(int from, int to) {
        return from + static_cast<int>(below(static_cast<std::size_t>(to - from) + 1));
    }
    /// 0 up to 1.
    [[nodiscard]] double share() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; }
    [[nodiscard]] bool oneIn(std::size_t count) { return below(count) == 0; }

private:
    std::mt19937_64 m_engine;  // its numbers are fixed by the standard; those of distributions are not
};

}  // namespace soak
