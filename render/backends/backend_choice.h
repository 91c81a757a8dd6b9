#pragma once

#include <vector>

#include "render/backends/measured_backends.h"
#include "render/culling/frame_plan.h"

namespace render {

/// Which back end draws a frame.
struct BackendChoice {
    Backend backend = Backend::Pull;
    const char* needs = nullptr;  ///< where the one requested cannot: what it needs, to go on after its name
};

/// The one requested, where it can draw this frame on this device; else, and for Auto, the one that suits best: in
/// tilted views what was measured to be fastest, if that is known and can draw the frame. `isSmoothed`: with several
/// samples per pixel, if the back end can.
[[nodiscard]] BackendChoice chooseBackend(Backend wanted, const gpu::Caps& caps, const FramePlan& plan, bool isSmoothed,
                                          const MeasuredBackends& measured = {});

/// Those that this device draws tilted views with, as long as the eye is outside all layers.
[[nodiscard]] std::vector<Backend> tiltedBackends(const gpu::Caps& caps, bool isSmoothed);

}  // namespace render
