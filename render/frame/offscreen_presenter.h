#pragma once

#include "render/frame/renderer.h"
#include "render/scene/board_scene.h"

namespace render {

/// Draws to memory: command line, tests, screenshots, and windows on platforms without a Vulkan surface.
class OffscreenPresenter {
public:
    explicit OffscreenPresenter(gpu::Device& device);

    /// Draws one frame and waits for it. `width` and `height` up to the device's largest image.
    /// Errors: BadUsage (size), DeviceFailed.
    [[nodiscard]] base::Result<Image> render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                             std::uint32_t width, std::uint32_t height);
    [[nodiscard]] FrameStats stats() const { return m_stats; }
    /// As Renderer::makeReady.
    void makeReady(Backend backend);

private:
    base::Result<Image> draw(BoardScene& scene, const Camera& camera, const ViewSettings& settings, VkExtent2D extent);
    void copyPicture(VkCommandBuffer commands);
    [[nodiscard]] Image takePicture() const;

    gpu::Device* m_device;
    gpu::FrameRing m_ring;
    Renderer m_renderer;
    RenderTarget m_target;
    gpu::Buffer m_readback;
    FrameStats m_stats;
};

}  // namespace render
