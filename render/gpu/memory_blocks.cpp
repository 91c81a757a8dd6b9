#include "render/gpu/memory_blocks.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

std::string describe(const MemoryOptions& options) {
    char text[128];
    std::snprintf(text, sizeof text, "%.*s (%.1f MB)", static_cast<int>(options.label.size()), options.label.data(),
                  static_cast<double>(options.requirements.size) * 1e-6);
    return text;
}

void nameMemory(const Device& device, VkDeviceMemory memory, std::string_view label) {
    device.name(VK_OBJECT_TYPE_DEVICE_MEMORY, reinterpret_cast<std::uint64_t>(memory), label);
}

}  // namespace

MemoryBlocks::MemoryBlocks(VkPhysicalDevice physical, VkDevice device) : m_device(device) {
    vkGetPhysicalDeviceMemoryProperties(physical, &m_properties);
}

MemoryBlocks::~MemoryBlocks() {
    for (const auto& [key, pool] : m_pools) {
        for (const Block& block : pool) {
            vkFreeMemory(m_device, block.allocation.memory, nullptr);
        }
    }
}

/// Memory types that will do, best first, each once.
std::vector<std::uint32_t> MemoryBlocks::typesFor(const MemoryOptions& options) const {
    std::vector<std::uint32_t> types;
    std::uint32_t allowed = options.requirements.memoryTypeBits;
    for (const VkMemoryPropertyFlags flags : {options.required | options.wanted, options.required}) {
        for (std::uint32_t i = 0; i < m_properties.memoryTypeCount; ++i) {
            const std::uint32_t bit = 1U << i;
            if ((allowed & bit) != 0 && (m_properties.memoryTypes[i].propertyFlags & flags) == flags) {
                types.push_back(i);
                allowed &= ~bit;
            }
        }
    }
    return types;
}

MemoryReport MemoryBlocks::report() const {
    const std::lock_guard lock(m_mutex);
    return m_report;
}

MemoryPart MemoryBlocks::take(Device& device, const MemoryOptions& options) {
    const std::lock_guard lock(m_mutex);
    if (!device.mayAllocate(options.requirements.size)) {
        throw OutOfMemory{describe(options)};
    }
    for (const std::uint32_t type : typesFor(options)) {
        if (const std::optional<MemoryPart> part = takeOf(type, device, options)) {
            m_report.bytes[static_cast<std::size_t>(part->use)] += part->bytes;
            return *part;
        }
    }
    throw OutOfMemory{describe(options)};
}

std::optional<MemoryPart> MemoryBlocks::takeOf(std::uint32_t type, Device& device, const MemoryOptions& options) {
    const std::uint64_t bytes = options.requirements.size;
    if (bytes < kSmallestBlock) {
        if (const std::optional<MemoryPart> part = takeShared(type, device, options)) {
            return part;
        }
    }
    // Where there is no room for a block there may be some for this alone.
    const bool isMapped = (options.required & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
    const Allocation own = allocate({type, options.isBuffer}, bytes, isMapped);
    if (own.memory == VK_NULL_HANDLE) {
        return std::nullopt;
    }
    nameMemory(device, own.memory, options.label);
    return MemoryPart{own.memory, 0, bytes, options.use, own.mapped};
}

std::optional<MemoryPart> MemoryBlocks::takeShared(std::uint32_t type, Device& device, const MemoryOptions& options) {
    const PoolKey key{type, options.isBuffer};
    const VkMemoryRequirements& needs = options.requirements;
    Pool& pool = m_pools[key];
    for (std::size_t i = 0; i < pool.size() || addBlock(pool, key, device); ++i) {
        const auto& [memory, mapped] = pool[i].allocation;
        if (const std::optional<std::uint64_t> offset = pool[i].ranges.take(needs.size, needs.alignment)) {
            return MemoryPart{memory, *offset, needs.size, options.use, mapped != nullptr ? mapped + *offset : nullptr};
        }
    }
    return std::nullopt;
}

bool MemoryBlocks::addBlock(Pool& pool, const PoolKey& key, Device& device) {
    std::uint64_t before = 0;
    for (const Block& block : pool) {
        before += block.ranges.bytes();
    }
    const std::uint64_t bytes = std::clamp(before, kSmallestBlock, kLargestBlock);
    const VkMemoryPropertyFlags flags = m_properties.memoryTypes[key.first].propertyFlags;
    const bool isMapped = (flags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
    const Allocation made = device.isWithinLimits(bytes) ? allocate(key, bytes, isMapped) : Allocation{};
    if (made.memory == VK_NULL_HANDLE) {
        return false;
    }
    nameMemory(device, made.memory, key.second ? "block of buffers" : "block of images");
    pool.push_back({made, FreeRanges(bytes)});
    return true;
}

/// No memory where the device has no room.
MemoryBlocks::Allocation MemoryBlocks::allocate(const PoolKey& key, std::uint64_t bytes, bool isMapped) {
    const auto [type, isOfBuffers] = key;
    auto flags = vkInfo<VkMemoryAllocateFlagsInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO);
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    auto info = vkInfo<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.pNext = isOfBuffers ? &flags : nullptr;
    info.allocationSize = bytes;
    info.memoryTypeIndex = type;
    Allocation made;
    if (vkAllocateMemory(m_device, &info, nullptr, &made.memory) != VK_SUCCESS) {
        return {};
    }
    void* mapped = nullptr;
    if (isMapped && vkMapMemory(m_device, made.memory, 0, VK_WHOLE_SIZE, 0, &mapped) != VK_SUCCESS) {
        vkFreeMemory(m_device, made.memory, nullptr);
        return {};
    }
    made.mapped = static_cast<std::byte*>(mapped);
    m_report.heldBytes += bytes;
    ++m_report.allocations;
    return made;
}

void MemoryBlocks::release(VkDeviceMemory memory, std::uint64_t bytes) {
    vkFreeMemory(m_device, memory, nullptr);
    m_report.heldBytes -= bytes;
    --m_report.allocations;
}

void MemoryBlocks::give(const MemoryPart& part) {
    const std::lock_guard lock(m_mutex);
    m_report.bytes[static_cast<std::size_t>(part.use)] -= part.bytes;
    for (auto& [key, pool] : m_pools) {
        const auto block = std::ranges::find(pool, part.memory, [](const Block& b) { return b.allocation.memory; });
        if (block != pool.end()) {
            block->ranges.give(part.offset, part.bytes);
            releaseSpare(pool);
            return;
        }
    }
    release(part.memory, part.bytes);
}

/// The first empty block is kept, and there is no third.
void MemoryBlocks::releaseSpare(Pool& pool) {
    const auto isEmpty = [](const Block& block) { return block.ranges.isAllFree(); };
    const auto kept = std::ranges::find_if(pool, isEmpty);
    if (kept == pool.end()) {
        return;
    }
    const auto spare = std::find_if(kept + 1, pool.end(), isEmpty);
    if (spare != pool.end()) {
        release(spare->allocation.memory, spare->ranges.bytes());
        pool.erase(spare);
    }
}

}  // namespace render::gpu
