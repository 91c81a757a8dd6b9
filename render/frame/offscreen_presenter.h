#pragma once

#include <memory>

#include "render/scene/board_scene.h"
#include "render/scene/camera.h"

namespace render {

/// Draws to memory: command line, tests, screenshots, and windows on platforms without a Vulkan surface.
class OffscreenPresenter {
public:
    explicit OffscreenPresenter(gpu::Device& device);
    ~OffscreenPresenter();
    OffscreenPresenter(OffscreenPresenter&&) noexcept;
    OffscreenPresenter& operator=(OffscreenPresenter&&) noexcept;

    /// Draws one frame and waits for it. `width` and `height` up to the device's largest image.
    /// Errors: BadUsage (size), DeviceFailed.
    [[nodiscard]] base::Result<Image> render(BoardScene& scene, const Camera& camera, const ViewSettings& settings,
                                             std::uint32_t width, std::uint32_t height);
    [[nodiscard]] FrameStats stats() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace render
