#include "render/backends/let_backend.h"

#include "render/gpu/device_select.h"

namespace render {

PassPipelines makePassPipelines(gpu::Device& device, std::string_view label, std::span<const gpu::ShaderStage> stages,
                                bool cullsBackFaces, const TargetFormat& target, gpu::Cover cover) {
    PassPipelines pipelines;
    for (const gpu::Pass pass : {gpu::Pass::Opaque, gpu::Pass::DepthOnly, gpu::Pass::Blend}) {
        pipelines[passRow(pass)] =
            gpu::Pipeline(device, {label, stages, sizeof(shader::Push), pass, cullsBackFaces, cover, target.colour,
                                   gpu::kDepthFormat, target.samples, target.hasSection});
    }
    return pipelines;
}

}  // namespace render
