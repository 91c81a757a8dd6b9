#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "render/gpu/deferred_destroy.h"

namespace render::gpu {

/// What a device made of a pipeline's options.
struct MadePipeline {
    Unique<VkPipelineLayout> layout;
    Unique<VkPipeline> handle;
    VkShaderStageFlags stages = 0;
    VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
};

/// The pipelines of a device, each made once and kept as long as the device: windows, pictures and boards that come and
/// go share them. Making one takes milliseconds, and software devices keep memory of each that was ever made.
class PipelineStore {
public:
    /// All that tells pipelines apart, in numbers.
    using Key = std::vector<std::uint64_t>;
    /// The one of `key`, which `make` makes when it is asked for first. On any thread.
    [[nodiscard]] const MadePipeline& get(const Key& key, const std::function<MadePipeline()>& make);
    [[nodiscard]] std::size_t count() const;

private:
    mutable std::mutex m_mutex;
    std::map<Key, std::unique_ptr<const MadePipeline>> m_made;
};

}  // namespace render::gpu
