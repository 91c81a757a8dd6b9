#pragma once

#include <cstddef>
#include <span>

#include "render/gpu/deferred_destroy.h"
#include "render/gpu/memory.h"

namespace render::gpu {

/// What the program does with a buffer, which is mapped for good then.
enum class HostAccess : std::uint8_t {
    None,
    Writes,  ///< it lies in the device's own memory where the program reaches that, so that the device reads it fast
    Reads    ///< it lies where the program reads it fast
};

struct BufferOptions {
    std::string_view label;
    std::uint64_t size = 0;  ///< bytes; 0 makes a small buffer, so that an empty board needs no special case
    MemoryUse use = MemoryUse::Geometry;
    HostAccess host = HostAccess::None;
};

/// A buffer that may serve as anything: storage by address, vertex indices, indirect commands, copies.
class Buffer {
public:
    Buffer() = default;
    Buffer(Device& device, const BufferOptions& options);

    [[nodiscard]] VkBuffer handle() const { return m_handle.get(); }
    [[nodiscard]] VkDeviceAddress address() const { return m_address; }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// The whole buffer; empty unless the program reaches it.
    [[nodiscard]] std::span<std::byte> mapped() const { return {m_mapped, m_mapped == nullptr ? 0 : m_size}; }

private:
    Memory m_memory;
    Unique<VkBuffer> m_handle;
    VkDeviceAddress m_address = 0;
    std::uint64_t m_size = 0;
    std::byte* m_mapped = nullptr;
};

}  // namespace render::gpu
