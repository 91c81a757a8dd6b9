#pragma once

#include "render/let_backend.h"
#include "render/view.h"

namespace render {

/// Blends an overlay over what a frame has drawn. The pixels go through the memory of the frame: nothing is kept on the
/// device, and a view without an overlay costs nothing.
class OverlayDrawer {
public:
    OverlayDrawer(gpu::Device& device, const TargetFormat& target);
    [[nodiscard]] const TargetFormat& format() const { return m_format; }
    void draw(gpu::Frame& frame, const Overlay& overlay) const;

private:
    TargetFormat m_format;
    gpu::Pipeline m_pipeline;
};

}  // namespace render
