#include "render/gpu/pipeline_store.h"

namespace render::gpu {

const MadePipeline& PipelineStore::get(const Key& key, const std::function<MadePipeline()>& make) {
    {
        const std::lock_guard lock(m_mutex);
        if (const auto found = m_made.find(key); found != m_made.end()) {
            return *found->second;
        }
    }
    // Others need not wait for this one; where two threads make the same, the first to be done is kept.
    auto made = std::make_unique<const MadePipeline>(make());
    const std::lock_guard lock(m_mutex);
    return *m_made.try_emplace(key, std::move(made)).first->second;
}

std::size_t PipelineStore::count() const {
    const std::lock_guard lock(m_mutex);
    return m_made.size();
}

}  // namespace render::gpu
