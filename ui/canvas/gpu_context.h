#pragma once

#include <memory>

#include "model/base/result.h"
#include "render/gpu/device.h"
#include "render/gpu/instance.h"
#include "ui/canvas/device_turns.h"

class QVulkanInstance;

namespace ui {

/// The one Vulkan instance and device of the process. They are made without Qt; where the platform has Vulkan surfaces
/// Qt adopts the instance so that windows can be drawn to, elsewhere (the offscreen platform, for one) pictures are
/// drawn to memory. Outlives all windows.
class GpuContext {
public:
    /// Needs a QGuiApplication. Errors: DeviceFailed when no device can draw at all.
    [[nodiscard]] static base::Result<std::unique_ptr<GpuContext>> create();
    ~GpuContext();
    GpuContext(const GpuContext&) = delete;
    GpuContext& operator=(const GpuContext&) = delete;

    [[nodiscard]] render::gpu::Device& device() { return *m_device; }
    /// For what the window does not wait for.
    [[nodiscard]] DeviceTurns& turns() { return m_turns; }
    /// For QWindow::setVulkanInstance; null where windows cannot be drawn to.
    [[nodiscard]] QVulkanInstance* surfaceInstance() const { return m_canPresent ? m_qtInstance.get() : nullptr; }
    /// Errors the validation layer has reported; stays 0 when it is off.
    [[nodiscard]] std::uint32_t validationErrors() const { return m_instance->validationErrors(); }
    /// After a device was lost: makes a new one. Everything made from the old one must be gone. Errors: DeviceFailed;
    /// the lost one stays.
    [[nodiscard]] base::Status renewDevice();

private:
    GpuContext() = default;
    [[nodiscard]] base::Status makeInstance();
    /// One that can present to `surface`; null: any.
    [[nodiscard]] base::Status makeDevice(VkSurfaceKHR surface);

    // Destroyed from the bottom up: the device before the instances.
    std::unique_ptr<render::gpu::Instance> m_instance;
    std::unique_ptr<QVulkanInstance> m_qtInstance;
    std::unique_ptr<render::gpu::Device> m_device;
    bool m_canPresent = false;
    DeviceTurns m_turns;
};

}  // namespace ui
