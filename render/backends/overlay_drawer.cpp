#include "render/backends/overlay_drawer.h"

#include "render/gpu/image.h"
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

void OverlayDrawer::draw(gpu::Frame& frame, const Overlay& overlay, const shader::OverlayPush& push) const {
    shader::OverlayPush whole = push;
    whole.pixels = frame.put(std::span(overlay.rgba, std::size_t{overlay.width} * overlay.height * 4)).address;
    whole.width = overlay.width;
    whole.height = overlay.height;
    m_pipeline.bind(frame.commands());
    m_pipeline.push(frame.commands(), whole);
    vkCmdDraw(frame.commands(), 3, 1, 0, 0);
}

void OverlayDrawer::draw(gpu::Frame& frame, const Overlay& overlay) const {
    draw(frame, overlay, shader::OverlayPush{});
}

void OverlayDrawer::drawInPlane(gpu::Frame& frame, const Overlay& overlay, const glm::vec3& plane,
                                VkDeviceAddress depths) const {
    shader::OverlayPush push{};
    push.plane = plane;
    push.depths = depths;
    push.isInPlane = 1;
    draw(frame, overlay, push);
}

}  // namespace render
