#include "render/gpu/buffer.h"

#include <algorithm>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

constexpr std::uint64_t kSmallest = 16;
constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                                      VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
constexpr VkMemoryPropertyFlags kMappable = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

Unique<VkBuffer> createBuffer(Device& device, const BufferOptions& options) {
    auto info = vkInfo<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = std::max(options.size, kSmallest);
    info.usage = kUsage;
    VkBuffer handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateBuffer(device.handle(), &info, nullptr, &handle));
    return {device, handle, options.label};
}

MemoryOptions memoryFor(Device& device, VkBuffer buffer, const BufferOptions& options) {
    MemoryOptions memory;
    vkGetBufferMemoryRequirements(device.handle(), buffer, &memory.requirements);
    memory.required = options.host != HostAccess::None ? kMappable : 0;
    memory.wanted =
        options.host == HostAccess::Reads ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    memory.use = options.use;
    memory.isBuffer = true;
    memory.label = options.label;
    return memory;
}

}  // namespace

Buffer::Buffer(Device& device, const BufferOptions& options)
    : m_handle(createBuffer(device, options)), m_size(std::max(options.size, kSmallest)) {
    m_memory = Memory(device, memoryFor(device, handle(), options));
    const MemoryPart& part = m_memory.part();
    VK_CHECK(vkBindBufferMemory(device.handle(), handle(), part.memory, part.offset));
    auto info = vkInfo<VkBufferDeviceAddressInfo>(VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO);
    info.buffer = handle();
    m_address = vkGetBufferDeviceAddress(device.handle(), &info);
    m_mapped = options.host != HostAccess::None ? part.mapped : nullptr;
}

}  // namespace render::gpu
