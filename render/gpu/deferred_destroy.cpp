#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

void DeferredDestroy::collect(std::uint64_t done) {
    const std::lock_guard lock(m_mutex);
    while (!m_retired.empty() && m_retired.front().after <= done) {
        m_retired.front().destroy();
        m_retired.pop_front();
    }
}

void DeferredDestroy::noteAllocation(VkDeviceMemory memory, MemoryUse use, std::uint64_t bytes) {
    m_allocations[memory] = {use, bytes};
    m_report.bytes[static_cast<std::size_t>(use)] += bytes;
}

void DeferredDestroy::noteFree(VkDeviceMemory memory) {
    const auto found = m_allocations.find(memory);
    ASSERT(found != m_allocations.end());
    m_report.bytes[static_cast<std::size_t>(found->second.use)] -= found->second.bytes;
    m_allocations.erase(found);
}

}  // namespace render::gpu
