#include "render/frame/swapchain_presenter.h"

#include <spdlog/spdlog.h>

#include "model/base/stopwatch.h"
#include "render/gpu/barrier.h"
#include "render/gpu/check.h"

namespace render {
namespace {

/// One being copied while one is being shown.
constexpr std::uint32_t kCopiesInFlight = 2;

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
      m_ring(device, 1, "window frames"),
      m_copies(device, kCopiesInFlight, "window copies"),
      m_renderer(device),
      m_target(device) {}

SwapchainPresenter::Outcome SwapchainPresenter::setSize(std::uint32_t width, std::uint32_t height) {
    m_swapchain.resize({width, height});
    return m_swapchain.makeReady();
}

bool SwapchainPresenter::tryToDraw(BoardScene* scene, const Camera& camera, const ViewSettings& settings) {
    gpu::Frame* frame = m_ring.begin();
    if (frame == nullptr) {
        return false;
    }
    const base::Stopwatch watch;
    m_stats.backend =
        m_renderer.record(*frame, m_target, m_swapchain.extent(), m_swapchain.drawFormat(), scene, camera, settings);
    const bool isSubmitted = m_ring.end();
    m_stats.isByDevice = true;
    m_stats.isOverlayAlone = m_renderer.drewOverlayAlone();
    m_stats.cpuMs = watch.milliseconds();
    return isSubmitted;
}

bool SwapchainPresenter::draw(BoardScene* scene, const Camera& camera, const ViewSettings& settings) {
    if (const base::Status loaded = scene != nullptr ? scene->load() : base::Done{}; !loaded) {
        spdlog::error("{}", loaded.error().text);
        m_device->markLost();
        return false;
    }
    try {
        return tryToDraw(scene, camera, settings);
    } catch (const gpu::OutOfMemory& shortage) {
        // Only a device made anew is sure to give back what was begun.
        spdlog::error("{} has no memory for {}.", m_device->caps().name, shortage.what);
        m_device->markLost();
        return false;
    }
}

SwapchainPresenter::Outcome SwapchainPresenter::present() {
    m_stats.gpuMs = m_ring.gpuMs();
    gpu::Swapchain::Target image;
    if (const Outcome outcome = m_swapchain.acquire(image); outcome != Outcome::Done) {
        return outcome;
    }
    gpu::Frame* frame = m_copies.begin();
    if (frame == nullptr) {
        return Outcome::DeviceLost;
    }
    frame->leaveUntimed();
    copyToWindow(frame->commands(), m_target, image.image);
    return m_copies.end({image.available, image.finished}) ? m_swapchain.present(image) : Outcome::DeviceLost;
}

}  // namespace render
