#pragma once

#include <memory>

#include "app/common/headless_device.h"
#include "tri/gpu/triangulator.h"

namespace app {

/// A Vulkan device opened for nothing but triangulating.
class DeviceTriangulator {
public:
    /// Errors: DeviceFailed.
    [[nodiscard]] static base::Result<DeviceTriangulator> open();

    [[nodiscard]] tri::gpu::Triangulator& get() { return *m_triangulator; }
    /// "llvmpipe (LLVM 15.0.6, 256 bits)".
    [[nodiscard]] const std::string& deviceName() const { return m_device.device->caps().name; }
    [[nodiscard]] bool isSoftware() const { return m_device.device->caps().isCpu; }

private:
    explicit DeviceTriangulator(HeadlessDevice device);

    HeadlessDevice m_device;
    std::unique_ptr<tri::gpu::Triangulator> m_triangulator;
};

}  // namespace app
