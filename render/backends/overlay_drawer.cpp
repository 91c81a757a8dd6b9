#include "render/backends/overlay_drawer.h"

#include "render/gpu/image.h"
#include "shaders/shared/overlay.h"
#include "shaders/spirv.h"

namespace render {
namespace {

gpu::Pipeline makePipeline(gpu::Device& device, VkFormat colour) {
    const auto stages = gpu::drawStages(shader::spirv::kOverlayVert, shader::spirv::kOverlayFrag);
    return gpu::Pipeline(
        device, gpu::GraphicsPipelineOptions{"overlay", stages, sizeof(shader::OverlayPush), gpu::Pass::Overlay, false,
                                             gpu::Cover::Triangles, colour});
}

}  // namespace

OverlayDrawer::OverlayDrawer(gpu::Device& device, VkFormat colour) : m_pipeline(makePipeline(device, colour)) {}

void OverlayDrawer::draw(gpu::Frame& frame, const Overlay& overlay) const {
    const std::span pixels(overlay.rgba, std::size_t{overlay.width} * overlay.height * 4);
    const gpu::Frame::Slice slice = frame.put(pixels);
    m_pipeline.bind(frame.commands());
    m_pipeline.push(frame.commands(), shader::OverlayPush{slice.address, overlay.width, overlay.height});
    vkCmdDraw(frame.commands(), 3, 1, 0, 0);
}

}  // namespace render
