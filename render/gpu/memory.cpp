#include "render/gpu/memory.h"

#include <cstdio>
#include <vector>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

/// Memory types that will do, best first.
std::vector<std::uint32_t> typesFor(VkPhysicalDevice device, const MemoryOptions& options) {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    std::vector<std::uint32_t> types;
    for (const VkMemoryPropertyFlags flags : {options.required | options.wanted, options.required}) {
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            const bool isAllowed = (options.requirements.memoryTypeBits & (1U << i)) != 0;
            if (isAllowed && (memory.memoryTypes[i].propertyFlags & flags) == flags) {
                types.push_back(i);
            }
        }
    }
    return types;
}

std::string describe(const MemoryOptions& options) {
    char text[128];
    std::snprintf(text, sizeof text, "%.*s (%.1f MB)", static_cast<int>(options.label.size()), options.label.data(),
                  static_cast<double>(options.requirements.size) * 1e-6);
    return text;
}

}  // namespace

Unique<VkDeviceMemory> allocate(Device& device, const MemoryOptions& options) {
    auto flags = vkInfo<VkMemoryAllocateFlagsInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO);
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    auto info = vkInfo<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.pNext = options.hasAddress ? &flags : nullptr;
    info.allocationSize = options.requirements.size;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
    if (!device.mayAllocate(options.requirements.size)) {
        throw OutOfMemory{describe(options)};
    }
    for (const std::uint32_t type : typesFor(device.physical(), options)) {
        info.memoryTypeIndex = type;
        result = vkAllocateMemory(device.handle(), &info, nullptr, &memory);
        if (result == VK_SUCCESS) {
            break;
        }
    }
    if (result != VK_SUCCESS) {
        throw OutOfMemory{describe(options)};
    }
    device.deferred().noteAllocation(memory, options.use, options.requirements.size);
    return {device, memory, options.label};
}

}  // namespace render::gpu
