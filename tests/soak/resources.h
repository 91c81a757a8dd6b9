#pragma once

#include <cstdint>
#include <string>

#include "render/gpu/device.h"

namespace soak {

/// What this process holds.
struct Resources {
    std::uint64_t residentBytes = 0;
    std::uint64_t heapBytes =
        0;  ///< given out by malloc and not given back; 0 under a sanitizer with a heap of its own
    std::uint64_t deviceBytes = 0;
    std::size_t handles = 0;  ///< open files, sockets and pipes
    std::size_t threads = 0;
};

[[nodiscard]] Resources resourcesNow(const render::gpu::Device& device);
[[nodiscard]] std::size_t threadsNow();
/// "212.4 MB resident, 81.0 MB heap, 3.1 MB device, 41 handles, 9 threads"
[[nodiscard]] std::string textOf(const Resources& resources);

}  // namespace soak
