#include "model/base/large_pages.h"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <cstdint>

namespace base {

void preferLargePages(std::span<const std::byte> memory) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t kLarge = 2U << 20U;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory.data()) + kLarge - 1) / kLarge * kLarge;
    const auto end = reinterpret_cast<std::uintptr_t>(memory.data() + memory.size()) / kLarge * kLarge;
    if (begin < end) {
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
    }
#endif
}

}  // namespace base
