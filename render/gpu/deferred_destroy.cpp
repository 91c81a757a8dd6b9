#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

void DeferredDestroy::collect(std::uint64_t done) {
    const std::lock_guard lock(m_mutex);
    while (!m_retired.empty() && m_retired.front().after <= done) {
        m_retired.front().destroy();
        m_retired.pop_front();
    }
}

}  // namespace render::gpu
