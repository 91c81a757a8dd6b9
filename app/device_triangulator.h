#pragma once

#include <memory>

#include "render/gpu/device.h"
#include "render/gpu/instance.h"
#include "tri/gpu/triangulator.h"

namespace app {

/// A Vulkan device opened for nothing but triangulating.
class DeviceTriangulator {
public:
    /// Errors: DeviceFailed.
    [[nodiscard]] static base::Result<DeviceTriangulator> open();

    [[nodiscard]] tri::gpu::Triangulator& get() { return *m_triangulator; }
    /// "llvmpipe (LLVM 15.0.6, 256 bits)".
    [[nodiscard]] const std::string& deviceName() const { return m_device->caps().name; }
    [[nodiscard]] bool isSoftware() const { return m_device->caps().isCpu; }

private:
    DeviceTriangulator(render::gpu::Instance instance, render::gpu::Device device);

    // On the heap: what is made on a device keeps its address.
    std::unique_ptr<render::gpu::Instance> m_instance;
    std::unique_ptr<render::gpu::Device> m_device;
    std::unique_ptr<tri::gpu::Triangulator> m_triangulator;
};

}  // namespace app
