#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "render/gpu/device.h"
#include "render/gpu/free_ranges.h"

namespace render::gpu {

/// What a resource needs. `wanted` are tried first; when the device has no room left there, any memory that `required`
/// allows is taken.
struct MemoryOptions {
    VkMemoryRequirements requirements{};
    VkMemoryPropertyFlags required = 0;
    VkMemoryPropertyFlags wanted = 0;
    MemoryUse use = MemoryUse::Geometry;
    bool isBuffer = false;  ///< whose address shaders see; else an image in the device's own layout
    std::string_view label;
};

/// Where a resource lies.
struct MemoryPart {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint64_t offset = 0;  ///< of its first byte in `memory`
    std::uint64_t bytes = 0;
    MemoryUse use = MemoryUse::Geometry;
    std::byte* mapped = nullptr;  ///< its first byte for the program; never null where options require HOST_VISIBLE
};

/// The memory of a device, owned by it. Drivers make few and large allocations well: resources of less than a mebibyte
/// share blocks, larger ones have memory of their own. Buffers and images, and kinds of memory, never share a block, so
/// nothing needs to be kept between neighbours. The first block of a kind is small, each next one as large as those
/// before it together, up to a limit. Of the blocks of a kind that are empty, one is kept for what comes next.
///
/// What a resource finds in its memory may be what another one left there. Any thread may take and give.
class MemoryBlocks {
public:
    static constexpr std::uint64_t kSmallestBlock = std::uint64_t{1} << 20;
    static constexpr std::uint64_t kLargestBlock = std::uint64_t{16} << 20;

    MemoryBlocks(VkPhysicalDevice physical, VkDevice device);
    MemoryBlocks(const MemoryBlocks&) = delete;
    MemoryBlocks& operator=(const MemoryBlocks&) = delete;
    ~MemoryBlocks();

    /// Throws OutOfMemory, naming the resource, when there is no room or Device::mayAllocate says so.
    [[nodiscard]] MemoryPart take(Device& device, const MemoryOptions& options);
    /// Once no submission uses the part any more (memory.h).
    void give(const MemoryPart& part);
    [[nodiscard]] MemoryReport report() const;

private:
    /// An allocation of the device.
    struct Allocation {
        VkDeviceMemory memory = VK_NULL_HANDLE;
        std::byte* mapped = nullptr;
    };
    struct Block {
        Allocation allocation;
        FreeRanges ranges;
    };
    using Pool = std::vector<Block>;
    using PoolKey = std::pair<std::uint32_t, bool>;  ///< memory type; of buffers?

    [[nodiscard]] std::vector<std::uint32_t> typesFor(const MemoryOptions& options) const;
    [[nodiscard]] std::optional<MemoryPart> takeOf(std::uint32_t type, Device& device, const MemoryOptions& options);
    [[nodiscard]] std::optional<MemoryPart> takeShared(std::uint32_t type, Device& device,
                                                       const MemoryOptions& options);
    [[nodiscard]] bool addBlock(Pool& pool, const PoolKey& key, Device& device);
    [[nodiscard]] Allocation allocate(const PoolKey& key, std::uint64_t bytes, bool isMapped);
    void release(VkDeviceMemory memory, std::uint64_t bytes);
    void releaseSpare(Pool& pool);

    VkDevice m_device;
    VkPhysicalDeviceMemoryProperties m_properties{};
    mutable std::mutex m_mutex;  ///< of the next two
    std::map<PoolKey, Pool> m_pools;
    MemoryReport m_report;
};

}  // namespace render::gpu
