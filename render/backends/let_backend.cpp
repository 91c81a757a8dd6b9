#include "render/backends/let_backend.h"

#include <algorithm>

#include "model/base/parallel.h"
#include "render/gpu/device_select.h"

namespace render {

PassPipelines makePassPipelines(gpu::Device& device, std::string_view label, std::span<const gpu::ShaderStage> stages,
                                bool cullsBackFaces, const TargetFormat& target, gpu::Cover cover) {
    constexpr gpu::Pass kPasses[] = {gpu::Pass::Opaque, gpu::Pass::DepthOnly, gpu::Pass::Blend};
    PassPipelines pipelines;
    base::parallelFor(std::size(kPasses), [&](std::size_t i) {
        pipelines[passRow(kPasses[i])] =
            gpu::Pipeline(device, {label, stages, sizeof(shader::Push), kPasses[i], cullsBackFaces, cover,
                                   target.colour, gpu::kDepthFormat, target.samples, target.hasSection});
    });
    return pipelines;
}

glm::uvec2 cullGroups(std::uint32_t count) {
    const std::uint32_t groups = count / shader::kCullGroupSize + (count % shader::kCullGroupSize != 0 ? 1 : 0);
    return {std::min(groups, shader::kCullRow), (groups + shader::kCullRow - 1) / shader::kCullRow};
}

void dispatchCull(VkCommandBuffer commands, std::uint32_t count) {
    const glm::uvec2 groups = cullGroups(count);
    vkCmdDispatch(commands, groups.x, groups.y, 1);
}

}  // namespace render
