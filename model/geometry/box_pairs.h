#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "model/geometry/box_index.h"

namespace model {

/// Up to so many boxes are swept in the order of their left sides; more are looked up in a BoxIndex.
inline constexpr std::size_t kMostSwept = 500;

/// Calls `visit(i, j)` once for every pair of boxes that share a point, of which `isWanted(i)` or `isWanted(j)`; in an
/// order that depends on the boxes only.
template <class IsWanted, class Visit>
void visitPairs(std::span<const base::Box> boxes, const IsWanted& isWanted, const Visit& visit) {
    const auto count = static_cast<std::uint32_t>(boxes.size());
    if (count > kMostSwept) {
        const BoxIndex index(boxes);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (isWanted(i)) {
                index.visit(boxes[i], [&](std::uint32_t j) {
                    if (j > i || (j < i && !isWanted(j))) {
                        visit(i, j);
                    }
                });
            }
        }
        return;
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t row) { return std::pair(boxes[row].min.x, row); });
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t i = order[k];
        for (std::uint32_t l = k + 1; l < count && boxes[order[l]].min.x <= boxes[i].max.x; ++l) {
            const std::uint32_t j = order[l];
            if (boxes[i].meets(boxes[j]) && (isWanted(i) || isWanted(j))) {
                visit(i, j);
            }
        }
    }
}

}  // namespace model
