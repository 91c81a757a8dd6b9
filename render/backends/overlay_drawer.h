#pragma once

#include "render/backends/let_backend.h"
#include "render/scene/view_settings.h"
#include "shaders/shared/overlay.h"

namespace render {

/// Blends an overlay over a finished picture (RenderTarget::beginOver). The pixels go through the memory of the frame:
/// nothing is kept on the device, and a view without an overlay costs nothing.
class OverlayDrawer {
public:
    OverlayDrawer(gpu::Device& device, VkFormat colour);
    void draw(gpu::Frame& frame, const Overlay& overlay) const;
    /// `plane` is its depth (depthOfPlane), `depths` that of the board, which has the same size
    /// (RenderTarget::keepDepth).
    void drawInPlane(gpu::Frame& frame, const Overlay& overlay, const glm::vec3& plane, VkDeviceAddress depths) const;

private:
    void draw(gpu::Frame& frame, const Overlay& overlay, const shader::OverlayPush& push) const;

    gpu::Pipeline m_pipeline;
};

}  // namespace render
