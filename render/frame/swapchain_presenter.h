#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>

#include "render/frame/renderer.h"
#include "render/gpu/swapchain.h"
#include "render/scene/board_scene.h"

namespace render {

/// Draws to a window's surface. The surface belongs to the window system: the presenter makes and destroys only the
/// swapchain, and must be destroyed before the surface goes (with Qt: on SurfaceAboutToBeDestroyed). Colours are those
/// of OffscreenPresenter.
///
/// A frame has two halves, so that nobody waits for the device: `draw` has it begin a picture beside the window, and
/// once it `isDrawn`, `present` shows it. Presenting a picture that is not done yet would wait for it, and for all that
/// was submitted before, where the device is a software one.
class SwapchainPresenter {
public:
    using Outcome = gpu::Swapchain::Outcome;

    SwapchainPresenter(gpu::Device& device, VkSurfaceKHR surface);

    /// Before every picture: the window's size in pixels (not points). Cheap unless it has changed. Skipped where there
    /// is nothing to draw on.
    [[nodiscard]] Outcome setSize(std::uint32_t width, std::uint32_t height);
    /// Begins a picture; the one before must be drawn. `scene` may be null (background only). False: the device is
    /// lost.
    [[nodiscard]] bool draw(BoardScene* scene, const Camera& camera, const ViewSettings& settings);
    /// Is the picture done? Waits so many nanoseconds for it at most.
    [[nodiscard]] bool isDrawn(std::uint64_t patienceNs = 0) { return m_ring.poll(patienceNs); }
    /// Shows the picture that is drawn. Waits for the display's refresh (FIFO). Skipped where the window has another
    /// size by now: to be drawn again.
    [[nodiscard]] Outcome present();
    /// Of the picture that is drawn.
    [[nodiscard]] const FrameStats& stats() const { return m_stats; }

private:
    bool tryToDraw(BoardScene* scene, const Camera& camera, const ViewSettings& settings);

    gpu::Device* m_device;
    gpu::Swapchain m_swapchain;
    gpu::FrameRing m_ring;
    gpu::FrameRing m_copies;  ///< to the window
    Renderer m_renderer;
    RenderTarget m_target;
    FrameStats m_stats;
};

}  // namespace render
