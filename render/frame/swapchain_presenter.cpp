#include "render/frame/swapchain_presenter.h"

#include <spdlog/spdlog.h>

#include <chrono>

#include "render/frame/renderer.h"
#include "render/gpu/barrier.h"
#include "render/gpu/check.h"
#include "render/gpu/swapchain.h"

namespace render {
namespace {

using Clock = std::chrono::steady_clock;

/// One being drawn while one is being shown.
constexpr std::uint32_t kFramesInFlight = 2;

SwapchainPresenter::Outcome outcomeOf(gpu::Swapchain::Outcome outcome) {
    switch (outcome) {
        case gpu::Swapchain::Outcome::Ready: return SwapchainPresenter::Outcome::Drawn;
        case gpu::Swapchain::Outcome::NoImage: return SwapchainPresenter::Outcome::Skipped;
        case gpu::Swapchain::Outcome::DeviceLost: return SwapchainPresenter::Outcome::DeviceLost;
    }
    return SwapchainPresenter::Outcome::Skipped;
}

/// Copies the drawn picture bit by bit: both formats have the same channels, and the picture is already sRGB encoded.
void copyToWindow(VkCommandBuffer commands, const RenderTarget& target, VkImage window) {
    gpu::imageBarrier(commands, {window, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, gpu::kCopyWrite, gpu::kCopyWrite});
    VkImageCopy region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.dstSubresource = region.srcSubresource;
    region.extent = {target.extent().width, target.extent().height, 1};
    vkCmdCopyImage(commands, target.picture(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, window,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    gpu::imageBarrier(commands, {window, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                 VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, gpu::kCopyWrite, gpu::Access{}});
}

}  // namespace

struct SwapchainPresenter::Impl {
    gpu::Device* device;
    gpu::Swapchain swapchain;
    gpu::FrameRing ring;
    Renderer renderer;
    RenderTarget target;
    FrameStats stats;

    Impl(gpu::Device& owner, VkSurfaceKHR surface)
        : device(&owner),
          swapchain(owner, surface),
          ring(owner, kFramesInFlight, "window frames"),
          renderer(owner),
          target(owner) {}

    Outcome draw(BoardScene* scene, const Camera& camera, const ViewSettings& settings) {
        gpu::Swapchain::Target image;
        if (const auto outcome = swapchain.acquire(image); outcome != gpu::Swapchain::Outcome::Ready) {
            return outcomeOf(outcome);
        }
        gpu::Frame* frame = ring.begin();
        if (frame == nullptr) {
            return Outcome::DeviceLost;
        }
        const Clock::time_point start = Clock::now();
        const Backend backend =
            renderer.record(*frame, target, swapchain.extent(), swapchain.drawFormat(), scene, camera, settings);
        copyToWindow(frame->commands(), target, image.image);
        const bool isSubmitted = ring.end({image.available, image.finished});
        if (!renderer.drewOverlayAlone()) {
            const double cpuMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
            stats = {cpuMs, 0.0, backend, false};
        }
        return isSubmitted ? outcomeOf(swapchain.present(image)) : Outcome::DeviceLost;
    }
};

SwapchainPresenter::SwapchainPresenter(gpu::Device& device, VkSurfaceKHR surface)
    : m_impl(std::make_unique<Impl>(device, surface)) {}
SwapchainPresenter::~SwapchainPresenter() = default;
SwapchainPresenter::SwapchainPresenter(SwapchainPresenter&&) noexcept = default;
SwapchainPresenter& SwapchainPresenter::operator=(SwapchainPresenter&&) noexcept = default;

void SwapchainPresenter::resize(std::uint32_t width, std::uint32_t height) {
    m_impl->swapchain.resize({width, height});
}

SwapchainPresenter::Outcome SwapchainPresenter::draw(BoardScene* scene, const Camera& camera,
                                                     const ViewSettings& settings) {
    try {
        const Outcome outcome = m_impl->draw(scene, camera, settings);
        // A window resized between drawing and presenting takes no picture of its old size: once more with the new one.
        return outcome == Outcome::Skipped ? m_impl->draw(scene, camera, settings) : outcome;
    } catch (const gpu::OutOfMemory& shortage) {
        // The frame that was begun holds an image of the window: only a device made anew gives it back.
        spdlog::error("{} has no memory for {}.", m_impl->device->caps().name, shortage.what);
        m_impl->device->markLost();
        return Outcome::DeviceLost;
    }
}

std::optional<FrameStats> SwapchainPresenter::finishedStats() {
    if (!m_impl->ring.poll()) {
        return std::nullopt;
    }
    m_impl->stats.gpuMs = m_impl->ring.gpuMs();
    const FrameStats stats = m_impl->stats;
    m_impl->stats.isOverlayAlone = true;  // reported, until the board is drawn again
    return stats;
}

}  // namespace render
