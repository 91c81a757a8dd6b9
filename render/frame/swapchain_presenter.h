#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>

#include "render/frame/renderer.h"
#include "render/gpu/swapchain.h"
#include "render/scene/board_scene.h"

namespace render {

/// Draws to a window's surface. The surface belongs to the window system: the presenter makes and destroys only the
/// swapchain, and must be destroyed before the surface goes (with Qt: on SurfaceAboutToBeDestroyed). Colours are those
/// of OffscreenPresenter. Waits for the display's refresh (FIFO); draw only when something changed.
class SwapchainPresenter {
public:
    using Outcome = gpu::Swapchain::Outcome;

    SwapchainPresenter(gpu::Device& device, VkSurfaceKHR surface);

    /// The window's size in pixels (not points). Cheap; the swapchain follows with the next draw.
    void resize(std::uint32_t width, std::uint32_t height) { m_swapchain.resize({width, height}); }
    /// Draws and presents one frame; `scene` may be null (background only).
    Outcome draw(BoardScene* scene, const Camera& camera, const ViewSettings& settings);
    /// Of the last frame that drew the board, as soon as the device is done with all frames; none before. Told once:
    /// after that it says `isOverlayAlone`. Does not wait.
    [[nodiscard]] std::optional<FrameStats> finishedStats();

private:
    Outcome tryToDraw(BoardScene* scene, const Camera& camera, const ViewSettings& settings);

    gpu::Device* m_device;
    gpu::Swapchain m_swapchain;
    gpu::FrameRing m_ring;
    Renderer m_renderer;
    RenderTarget m_target;
    FrameStats m_stats;
};

}  // namespace render
