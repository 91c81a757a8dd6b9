#pragma once

#include "render/gpu/memory_blocks.h"

namespace render::gpu {

class DeferredDestroy;

/// Owns the memory of one resource: move-only, goes back after the submissions that may use it. Dropped after the
/// resource, so declared before it.
class Memory {
public:
    Memory() = default;
    /// Throws OutOfMemory as MemoryBlocks::take does.
    Memory(Device& device, const MemoryOptions& options);
    ~Memory();
    Memory(Memory&& other) noexcept;
    Memory& operator=(Memory&& other) noexcept;

    [[nodiscard]] const MemoryPart& part() const { return m_part; }

private:
    DeferredDestroy* m_deferred = nullptr;
    MemoryBlocks* m_blocks = nullptr;
    MemoryPart m_part;
};

}  // namespace render::gpu
