#include "render/frame/offscreen_presenter.h"

#include <cstring>

#include "model/base/stopwatch.h"
#include "render/frame/renderer.h"
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

base::Status checkSize(std::uint32_t width, std::uint32_t height, const gpu::Caps& caps) {
    const std::uint32_t largest = caps.maxImageSize;
    if (width == 0 || height == 0 || width > largest || height > largest) {
        return base::Error{base::ErrorCode::BadUsage,
                           "A picture of " + std::to_string(width) + "x" + std::to_string(height) +
                               " pixels cannot be drawn: each side must be 1 to " + std::to_string(largest) + "."};
    }
    if (!fitsOn(caps, {width, height}, VK_SAMPLE_COUNT_1_BIT)) {
        return base::Error{base::ErrorCode::BadUsage, "A picture of " + std::to_string(width) + "x" +
                                                          std::to_string(height) +
                                                          " pixels does not fit in the memory of " + caps.name + "."};
    }
    return base::Done{};
}

}  // namespace

struct OffscreenPresenter::Impl {
    gpu::Device* device;
    gpu::FrameRing ring;
    Renderer renderer;
    RenderTarget target;
    gpu::Buffer readback;
    FrameStats stats;

    explicit Impl(gpu::Device& owner)
        : device(&owner), ring(owner, 1, "offscreen frames"), renderer(owner), target(owner) {}

    void copyPicture(VkCommandBuffer commands) {
        const VkExtent2D extent = target.extent();
        const std::uint64_t bytes = std::uint64_t{extent.width} * extent.height * kBytesPerPixel;
        if (readback.size() < bytes) {
            readback = gpu::Buffer(*device, {"readback", bytes, gpu::MemoryUse::Staging, true});
        }
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {extent.width, extent.height, 1};
        vkCmdCopyImageToBuffer(commands, target.picture(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback.handle(), 1,
                               &region);
        gpu::memoryBarrier(commands, gpu::kCopyWrite, gpu::kHostRead);
    }

    base::Result<Image> draw(BoardScene& scene, const Camera& camera, const ViewSettings& settings, VkExtent2D extent) {
        const base::Stopwatch watch;
        gpu::Frame* frame = ring.begin();
        if (frame == nullptr) {
            return lostDevice();
        }
        stats.backend = renderer.record(*frame, target, extent, gpu::kColourFormat, &scene, camera, settings);
        stats.isOverlayAlone = renderer.drewOverlayAlone();
        copyPicture(frame->commands());
        const bool isSubmitted = ring.end();
        stats.cpuMs = watch.milliseconds();
        if (!isSubmitted || !ring.wait()) {
            return lostDevice();
        }
        stats.gpuMs = ring.gpuMs();
        return takePicture();
    }

    [[nodiscard]] Image takePicture() const {
        Image image{target.extent().width, target.extent().height, {}};
        image.rgba.resize(std::size_t{image.width} * image.height * kBytesPerPixel);
        std::memcpy(image.rgba.data(), readback.mapped().data(), image.rgba.size());
        return image;
    }
};

OffscreenPresenter::OffscreenPresenter(gpu::Device& device) : m_impl(std::make_unique<Impl>(device)) {}
OffscreenPresenter::~OffscreenPresenter() = default;
OffscreenPresenter::OffscreenPresenter(OffscreenPresenter&&) noexcept = default;
OffscreenPresenter& OffscreenPresenter::operator=(OffscreenPresenter&&) noexcept = default;

base::Result<Image> OffscreenPresenter::render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                               std::uint32_t width, std::uint32_t height) {
    Impl& impl = *m_impl;
    RETURN_IF_ERROR(checkSize(width, height, impl.device->caps()));
    try {
        return impl.draw(scene, camera, settings, {width, height});
    } catch (const gpu::OutOfMemory& shortage) {
        impl.device->waitIdle();  // what was begun is freed
        return noMemory(*impl.device, shortage);
    }
}

FrameStats OffscreenPresenter::stats() const {
    return m_impl->stats;
}

}  // namespace render
