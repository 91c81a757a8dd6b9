#pragma once

#include <memory>

#include "render/gpu/device.h"
#include "render/gpu/instance.h"

namespace app {

/// A Vulkan device for commands without a window.
struct HeadlessDevice {
    // On the heap: what is made on a device keeps its address.
    std::unique_ptr<render::gpu::Instance> instance;
    std::unique_ptr<render::gpu::Device> device;  ///< goes first

    /// Errors: DeviceFailed.
    [[nodiscard]] static base::Result<HeadlessDevice> open();
};

}  // namespace app
