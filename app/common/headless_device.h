#pragma once

#include <memory>

#include "render/gpu/device.h"
#include "render/gpu/instance.h"
#include "tri/gpu/triangulator.h"

namespace app {

/// A Vulkan device for commands without a window.
struct HeadlessDevice {
    // On the heap: what is made on a device keeps its address.
    std::unique_ptr<render::gpu::Instance> instance;
    std::unique_ptr<render::gpu::Device> device;  ///< goes first

    /// Errors: DeviceFailed.
    [[nodiscard]] static base::Result<HeadlessDevice> open();
};

/// A device opened for nothing but triangulating.
struct DeviceTriangulator {
    HeadlessDevice opened;
    std::unique_ptr<tri::gpu::Triangulator> triangulator;

    /// Errors: DeviceFailed.
    [[nodiscard]] static base::Result<DeviceTriangulator> open();
    [[nodiscard]] const render::gpu::Caps& caps() const { return opened.device->caps(); }
};

}  // namespace app
