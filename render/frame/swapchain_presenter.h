#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "render/frame/offscreen_presenter.h"

namespace render {

/// Draws to a window's surface. The surface belongs to the window system: the presenter makes and destroys only the
/// swapchain, and must be destroyed before the surface goes (with Qt: on SurfaceAboutToBeDestroyed). Colours are those
/// of OffscreenPresenter. Waits for the display's refresh (FIFO); draw only when something changed.
class SwapchainPresenter {
public:
    enum class Outcome {
        Drawn,
        Skipped,    ///< nothing to draw on: the window has no size yet, or the surface is gone
        DeviceLost  ///< or out of memory, without smoothing too: make a new device
    };

    SwapchainPresenter(gpu::Device& device, VkSurfaceKHR surface);
    ~SwapchainPresenter();
    SwapchainPresenter(SwapchainPresenter&&) noexcept;
    SwapchainPresenter& operator=(SwapchainPresenter&&) noexcept;

    /// The window's size in pixels (not points). Cheap; the swapchain follows with the next draw.
    void resize(std::uint32_t width, std::uint32_t height);
    /// Draws and presents one frame; `scene` may be null (background only).
    Outcome draw(BoardScene* scene, const Camera& camera, const ViewSettings& settings);
    /// Of the last frame that drew the board, as soon as the device is done with all frames; none before. Told once:
    /// after that it says `isOverlayAlone`. Does not wait.
    [[nodiscard]] std::optional<FrameStats> finishedStats();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace render
