#include "render/frame/swapchain_presenter.h"

#include <spdlog/spdlog.h>

#include "model/base/stopwatch.h"
#include "render/gpu/barrier.h"
#include "render/gpu/check.h"

namespace render {
namespace {

/// One being drawn while one is being shown.
constexpr std::uint32_t kFramesInFlight = 2;

/// Copies the drawn picture bit by bit: both formats have the same channels, and the picture is already sRGB encoded.
void copyToWindow(VkCommandBuffer commands, const RenderTarget& target, VkImage window) {
    gpu::imageBarrier(commands, {window, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, gpu::kCopyWrite, gpu::kCopyWrite});
    gpu::copyImage(commands, target.picture(), window, target.extent());
    gpu::imageBarrier(commands, {window, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                 VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, gpu::kCopyWrite, gpu::Access{}});
}

}  // namespace

SwapchainPresenter::SwapchainPresenter(gpu::Device& device, VkSurfaceKHR surface)
    : m_device(&device),
      m_swapchain(device, surface),
      m_ring(device, kFramesInFlight, "window frames"),
      m_renderer(device),
      m_target(device) {}

SwapchainPresenter::Outcome SwapchainPresenter::tryToDraw(BoardScene* scene, const Camera& camera,
                                                          const ViewSettings& settings) {
    gpu::Swapchain::Target image;
    if (const Outcome outcome = m_swapchain.acquire(image); outcome != Outcome::Done) {
        return outcome;
    }
    gpu::Frame* frame = m_ring.begin();
    if (frame == nullptr) {
        return Outcome::DeviceLost;
    }
    const base::Stopwatch watch;
    const Backend backend =
        m_renderer.record(*frame, m_target, m_swapchain.extent(), m_swapchain.drawFormat(), scene, camera, settings);
    copyToWindow(frame->commands(), m_target, image.image);
    const bool isSubmitted = m_ring.end({image.available, image.finished});
    if (!m_renderer.drewOverlayAlone()) {
        m_stats = {watch.milliseconds(), 0.0, backend, false};
    }
    return isSubmitted ? m_swapchain.present(image) : Outcome::DeviceLost;
}

SwapchainPresenter::Outcome SwapchainPresenter::draw(BoardScene* scene, const Camera& camera,
                                                     const ViewSettings& settings) {
    try {
        const Outcome outcome = tryToDraw(scene, camera, settings);
        // A window resized between drawing and presenting takes no picture of its old size: once more with the new one.
        return outcome == Outcome::Skipped ? tryToDraw(scene, camera, settings) : outcome;
    } catch (const gpu::OutOfMemory& shortage) {
        // The frame that was begun holds an image of the window: only a device made anew gives it back.
        spdlog::error("{} has no memory for {}.", m_device->caps().name, shortage.what);
        m_device->markLost();
        return Outcome::DeviceLost;
    }
}

std::optional<FrameStats> SwapchainPresenter::finishedStats() {
    if (!m_ring.poll()) {
        return std::nullopt;
    }
    m_stats.gpuMs = m_ring.gpuMs();
    const FrameStats stats = m_stats;
    m_stats.isOverlayAlone = true;  // reported, until the board is drawn again
    return stats;
}

}  // namespace render
