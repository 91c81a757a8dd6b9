#include "render/gpu/memory.h"

#include <utility>

#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

Memory::Memory(Device& device, const MemoryOptions& options)
    : m_deferred(&device.deferred()), m_blocks(&device.memory()), m_part(m_blocks->take(device, options)) {}

Memory::~Memory() {
    if (m_part.memory != VK_NULL_HANDLE) {
        m_deferred->later([blocks = m_blocks, part = m_part] { blocks->give(part); });
    }
}

Memory::Memory(Memory&& other) noexcept
    : m_deferred(other.m_deferred), m_blocks(other.m_blocks), m_part(std::exchange(other.m_part, {})) {}

Memory& Memory::operator=(Memory&& other) noexcept {
    std::swap(m_deferred, other.m_deferred);
    std::swap(m_blocks, other.m_blocks);
    std::swap(m_part, other.m_part);
    return *this;
}

}  // namespace render::gpu
