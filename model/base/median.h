#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace base {

/// The value in the middle, of an even number the larger of the two. Reorders the values; there must be at least one.
template <class T>
[[nodiscard]] T medianOf(std::vector<T>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace base
