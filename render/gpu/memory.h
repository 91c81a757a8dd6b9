#pragma once

#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

/// Memory for one resource. `wanted` are tried first; when the device has no room left there, any memory that
/// `required` allows is taken.
struct MemoryOptions {
    VkMemoryRequirements requirements{};
    VkMemoryPropertyFlags required = 0;
    VkMemoryPropertyFlags wanted = 0;
    MemoryUse use = MemoryUse::Geometry;
    bool hasAddress = false;  ///< for buffers whose address shaders see
    std::string_view label;
};

/// One allocation per resource: we have tens of resources, devices allow thousands of allocations. Throws
/// OutOfMemory when none is left.
[[nodiscard]] Unique<VkDeviceMemory> allocate(Device& device, const MemoryOptions& options);

}  // namespace render::gpu
