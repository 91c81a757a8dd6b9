#pragma once

#include <cstddef>
#include <cstdint>

namespace base {

/// Sorts rows by 32-bit keys: words with the key in the upper and the row in the lower half, given with rising rows.
/// Equal keys stay in order, so the result is that of sorting whole words, in three passes without comparisons, in two
/// where keys are below 2^22. `spare` has room for as many; the result is in one of the two, which is returned.
[[nodiscard]] std::uint64_t* sortByKey(std::uint64_t* words, std::uint64_t* spare, std::size_t count);

}  // namespace base
