#pragma once

#include "render/culling/frame_plan.h"

namespace render {

namespace gpu {
struct Caps;
}

/// Which back end draws a frame.
struct BackendChoice {
    Backend backend = Backend::Pull;
    const char* needs = nullptr;  ///< where the one requested cannot: what it needs, to go on after its name
};

/// The one requested, where it can draw this frame on this device; else, and for Auto, the one that suits best.
/// `isSmoothed`: with several samples per pixel, if the back end can.
[[nodiscard]] BackendChoice chooseBackend(Backend wanted, const gpu::Caps& caps, const FramePlan& plan,
                                          bool isSmoothed);

}  // namespace render
