#pragma once

#include <cstddef>
#include <span>

#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

struct BufferOptions {
    std::string_view label;
    std::uint64_t size = 0;  ///< bytes; 0 makes a small buffer, so that an empty board needs no special case
    MemoryUse use = MemoryUse::Geometry;
    bool isHostVisible = false;  ///< mapped for good; else only the device reaches it
};

/// A buffer that may serve as anything: storage by address, vertex indices, indirect commands, copies.
class Buffer {
public:
    Buffer() = default;
    Buffer(Device& device, const BufferOptions& options);

    [[nodiscard]] VkBuffer handle() const { return m_handle.get(); }
    [[nodiscard]] VkDeviceAddress address() const { return m_address; }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// The whole buffer; empty unless host visible.
    [[nodiscard]] std::span<std::byte> mapped() const { return {m_mapped, m_mapped == nullptr ? 0 : m_size}; }

private:
    Unique<VkDeviceMemory> m_memory;
    Unique<VkBuffer> m_handle;
    VkDeviceAddress m_address = 0;
    std::uint64_t m_size = 0;
    std::byte* m_mapped = nullptr;
};

}  // namespace render::gpu
