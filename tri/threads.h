#pragma once

#include <cstddef>
#include <cstdint>

#include "model/base/parallel.h"

namespace tri {

/// May one polygon use all cores? Many small ones are better off with one core each.
enum class Cores : std::uint8_t { One, All };

/// A polygon of this many points gains more from all cores than it costs to cut it into parts. Smaller ones are many:
/// they get a core each.
inline constexpr std::size_t kWorthAllCores = 100'000;
[[nodiscard]] constexpr Cores coresFor(std::size_t points) {
    return points < kWorthAllCores ? Cores::One : Cores::All;
}

/// Into how many pieces work that can be cut anywhere is cut: enough to level out cores of different speed.
[[nodiscard]] constexpr std::uint32_t piecesFor(Cores cores) {
    return cores == Cores::One ? 1 : 64;
}

template <class Task>
void forEach(Cores cores, std::size_t count, const Task& task) {
    if (cores == Cores::All) {
        base::parallelFor(count, task);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        task(i);
    }
}

}  // namespace tri
