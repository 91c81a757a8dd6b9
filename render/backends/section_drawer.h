#pragma once

#include "render/backends/let_backend.h"
#include "render/scene/section_plane.h"

namespace render {

/// Fills the cut of a section plane. The rectangles go through the memory of the frame:
/// nothing is kept on the device.
class SectionDrawer {
public:
    SectionDrawer(gpu::Device& device, const TargetFormat& target);
    /// Of visible layers, at the heights at which the plan draws them.
    void draw(gpu::Frame& frame, const FramePlan& plan, const SceneLayers& scene, const SectionCut& cut) const;

private:
    gpu::Pipeline m_pipeline;
};

}  // namespace render
