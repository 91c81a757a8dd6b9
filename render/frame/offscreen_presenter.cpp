#include "render/frame/offscreen_presenter.h"

#include <bit>
#include <cstring>

#include "model/base/stopwatch.h"
#include "render/gpu/barrier.h"
#include "render/gpu/check.h"
#include "render/gpu/device_select.h"

namespace render {
namespace {

constexpr std::uint64_t kBytesPerPixel = 4;

base::Error lostDevice() {
    return {base::ErrorCode::DeviceFailed, "The Vulkan device was lost while drawing."};
}

base::Error noMemory(const gpu::Device& device, const gpu::OutOfMemory& shortage) {
    return {base::ErrorCode::DeviceFailed, "The picture does not fit in the memory of " + device.caps().name +
                                               ": there is no room for " + shortage.what + "."};
}

}  // namespace

OffscreenPresenter::OffscreenPresenter(gpu::Device& device)
    : m_device(&device), m_ring(device, 1, "offscreen frames"), m_renderer(device), m_target(device) {}

base::Status OffscreenPresenter::checkSize(const gpu::Device& device, std::uint32_t width, std::uint32_t height) {
    const gpu::Caps& caps = device.caps();
    const std::uint32_t largest = caps.maxImageSize;
    const std::string picture = "A picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels ";
    if (width == 0 || height == 0 || width > largest || height > largest) {
        return base::Error{base::ErrorCode::BadUsage,
                           picture + "cannot be drawn: each side must be 1 to " + std::to_string(largest) + "."};
    }
    if (!fitsOn(caps, {width, height}, VK_SAMPLE_COUNT_1_BIT)) {
        return base::Error{base::ErrorCode::BadUsage, picture + "does not fit in the memory of " + caps.name + "."};
    }
    return base::Done{};
}

void OffscreenPresenter::makeReady(Backend backend, bool isSmoothed) {
    m_renderer.makeReady(gpu::kColourFormat, backend, isSmoothed);
}

std::function<void()> OffscreenPresenter::preparation(BoardScene& scene, const Camera& camera,
                                                      const ViewSettings& settings, std::uint32_t width,
                                                      std::uint32_t height) {
    if (!checkSize(*m_device, width, height) || !scene.load()) {
        return {};
    }
    return m_renderer.preparation(m_target, {width, height}, gpu::kColourFormat, scene, camera, settings);
}

void OffscreenPresenter::copyPicture(VkCommandBuffer commands) {
    const VkExtent2D extent = m_target.extent();
    const std::uint64_t bytes = std::uint64_t{extent.width} * extent.height * kBytesPerPixel;
    if (m_readback.size() < bytes) {
        m_readback = gpu::Buffer(*m_device, {"readback", bytes, gpu::MemoryUse::Staging, gpu::HostAccess::Reads});
    }
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyImageToBuffer(commands, m_target.picture(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, m_readback.handle(), 1,
                           &region);
    gpu::memoryBarrier(commands, gpu::kCopyWrite, gpu::kHostRead);
}

/// False: the device is lost.
bool OffscreenPresenter::submit(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                VkExtent2D extent) {
    const base::Stopwatch watch;
    gpu::Frame* frame = m_ring.begin();
    if (frame == nullptr) {
        return false;
    }
    m_stats.backend = m_renderer.record(*frame, m_target, extent, gpu::kColourFormat, &scene, camera, settings);
    m_stats.isByDevice = true;
    m_stats.isOverlayAlone = m_renderer.drewOverlayAlone();
    frame->endTiming();  // a window does not read back
    frame->beginStage("read back");
    copyPicture(frame->commands());
    const bool isSubmitted = m_ring.end();
    m_stats.cpuMs = watch.milliseconds();
    return isSubmitted;
}

FrameStats OffscreenPresenter::stats() const {
    FrameStats stats = m_stats;
    stats.gpuMs = m_ring.gpuMs();
    return stats;
}

base::Status OffscreenPresenter::begin(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                       std::uint32_t width, std::uint32_t height) {
    RETURN_IF_ERROR(checkSize(*m_device, width, height));
    RETURN_IF_ERROR(scene.load());
    try {
        return submit(scene, camera, settings, {width, height}) ? base::Status(base::Done{}) : lostDevice();
    } catch (const gpu::OutOfMemory& shortage) {
        m_device->waitIdle();  // what was begun is freed
        scene.impl().resendStates();
        return noMemory(*m_device, shortage);
    }
}

void OffscreenPresenter::take(std::span<std::uint32_t> pixels) const {
    const VkExtent2D extent = m_target.extent();
    ASSERT(pixels.size() == std::size_t{extent.width} * extent.height);
    const auto* source = reinterpret_cast<const std::uint32_t*>(m_readback.mapped().data());
    static_assert(std::endian::native == std::endian::little);  // bytes are red, green, blue, alpha
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint32_t own = source[i];
        pixels[i] = 0xff000000U | (own & 0xffU) << 16U | (own & 0xff00U) | (own >> 16U & 0xffU);
    }
}

base::Result<Image> OffscreenPresenter::render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                               std::uint32_t width, std::uint32_t height) {
    RETURN_IF_ERROR(begin(scene, camera, settings, width, height));
    if (!m_ring.wait()) {
        return lostDevice();
    }
    return image();
}

Image OffscreenPresenter::image() const {
    const VkExtent2D extent = m_target.extent();
    Image image{extent.width, extent.height, {}};
    image.rgba.resize(std::size_t{extent.width} * extent.height * kBytesPerPixel);
    std::memcpy(image.rgba.data(), m_readback.mapped().data(), image.rgba.size());
    return image;
}

}  // namespace render
