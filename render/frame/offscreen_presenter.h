#pragma once

#include <functional>
#include <span>

#include "render/frame/renderer.h"
#include "render/scene/board_scene.h"

namespace render {

/// Draws to memory: command line, tests, screenshots, and windows whose device is software or has no surface. A frame
/// may be drawn in two halves, so that nobody waits for it: once what `begin` began `isDone`, it can be taken.
class OffscreenPresenter {
public:
    explicit OffscreenPresenter(gpu::Device& device);

    /// Draws one frame and waits for it. `width` and `height` up to the device's largest image.
    /// Errors: BadUsage (size), DeviceFailed.
    [[nodiscard]] base::Result<Image> render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                             std::uint32_t width, std::uint32_t height);
    /// The first half of `render`: has the device begin a frame; the one before must be done.
    [[nodiscard]] base::Status begin(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                     std::uint32_t width, std::uint32_t height);
    /// Is it done? Waits so many nanoseconds for it at most. Never, once the device is lost.
    [[nodiscard]] bool isDone(std::uint64_t patienceNs = 0) { return m_ring.poll(patienceNs); }
    /// A copy of the frame that is done. On any thread, while no other frame is begun.
    [[nodiscard]] Image image() const;
    /// Whether a picture of this size can be drawn at all. Errors: BadUsage, saying what is the most.
    [[nodiscard]] static base::Status checkSize(const gpu::Device& device, std::uint32_t width, std::uint32_t height);
    /// Copies the frame that is done to as many pixels, 0xffRRGGBB, rows from the top.
    void take(std::span<std::uint32_t> pixels) const;
    /// Of the frame that is done.
    [[nodiscard]] FrameStats stats() const;
    /// As FrameRing::timeStages, and the stages of the frame that is done.
    void timeStages() { m_ring.timeStages(); }
    [[nodiscard]] std::span<const gpu::StageTime> stages() const { return m_ring.stages(); }
    /// As Renderer::makeReady.
    void makeReady(Backend backend, bool isSmoothed);
    /// As Renderer::preparation, for what `begin` would draw; empty where it would fail. While no frame is drawn.
    [[nodiscard]] std::function<void()> preparation(BoardScene& scene, const Camera& camera,
                                                    const ViewSettings& settings, std::uint32_t width,
                                                    std::uint32_t height);

private:
    [[nodiscard]] bool submit(BoardScene& scene, const Camera& camera, const ViewSettings& settings, VkExtent2D extent);
    void copyPicture(VkCommandBuffer commands);

    gpu::Device* m_device;
    gpu::FrameRing m_ring;
    Renderer m_renderer;
    RenderTarget m_target;
    gpu::Buffer m_readback;
    FrameStats m_stats;
};

}  // namespace render
