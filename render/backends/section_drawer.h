#pragma once

#include "render/backends/let_backend.h"
#include "render/scene/section_plane.h"

namespace render {

/// Fills the cut of a section plane. The trapezoids go through the memory of the frame:
/// nothing is kept on the device.
///
/// Seen from the side that is cut away, nothing that is left lies before the plane: the cut is then drawn over all of
/// it whatever its depth, since walls that are seen edge-on stray from theirs.
class SectionDrawer {
public:
    SectionDrawer(gpu::Device& device, const TargetFormat& target);
    /// Of visible layers, at the heights at which the plan draws them.
    void draw(gpu::Frame& frame, const FramePlan& plan, const SceneLayers& scene, const SectionCut& cut) const;

private:
    gpu::Pipeline m_inFront;  ///< seen from the side that is cut away
    gpu::Pipeline m_behind;   ///< seen through what is left
};

}  // namespace render
