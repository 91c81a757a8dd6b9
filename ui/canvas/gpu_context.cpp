#include "ui/canvas/gpu_context.h"

#include <vulkan/vulkan.h>  // before any Qt header: Qt would hide the prototypes

#include <QGuiApplication>
#include <QVulkanInstance>
#include <QWindow>

namespace ui {

namespace {

using render::gpu::Device;
using render::gpu::Instance;

struct PlatformSurface {
    const char* platform;  ///< QGuiApplication::platformName
    const char* extension;
};

constexpr PlatformSurface kPlatformSurfaces[] = {
    {"xcb", "VK_KHR_xcb_surface"},
    {"wayland", "VK_KHR_wayland_surface"},
    {"windows", "VK_KHR_win32_surface"},
    {"cocoa", "VK_EXT_metal_surface"},
};

/// The instance extensions this platform's windows need; none where Qt has no Vulkan surfaces.
std::vector<std::string> surfaceExtensions() {
    for (const PlatformSurface& entry : kPlatformSurfaces) {
        if (QGuiApplication::platformName().startsWith(QLatin1String(entry.platform))) {
            return {"VK_KHR_surface", entry.extension};
        }
    }
    return {};
}

/// A window that is never shown: the device must be able to present to surfaces like its own.
class ProbeWindow : public QWindow {
public:
    explicit ProbeWindow(QVulkanInstance& instance) {
        setSurfaceType(QSurface::VulkanSurface);
        setVulkanInstance(&instance);
        create();
    }
    [[nodiscard]] VkSurfaceKHR surface() { return QVulkanInstance::surfaceForWindow(this); }
};

}  // namespace

GpuContext::~GpuContext() = default;

base::Result<std::unique_ptr<GpuContext>> GpuContext::create() {
    std::unique_ptr<GpuContext> context(new GpuContext);
    RETURN_IF_ERROR(context->makeInstance());
    RETURN_IF_ERROR(context->renewDevice());
    return context;
}

base::Status GpuContext::makeInstance() {
    const std::vector<std::string> extensions = surfaceExtensions();
    base::Result<Instance> instance = Instance::create({.extensions = extensions});
    m_canPresent = instance.ok() && !extensions.empty();
    if (!instance && !extensions.empty()) {
        instance = Instance::create({});  // the driver may lack surfaces and still draw to memory
    }
    if (!instance) {
        return instance.error();
    }
    m_instance = std::make_unique<Instance>(std::move(*instance));
    if (m_canPresent) {
        m_qtInstance = std::make_unique<QVulkanInstance>();
        m_qtInstance->setVkInstance(m_instance->handle());
        m_canPresent = m_qtInstance->create();
    }
    return base::Done{};
}

base::Status GpuContext::renewDevice() {
    if (m_canPresent) {
        ProbeWindow probe(*m_qtInstance);
        m_canPresent = probe.surface() != VK_NULL_HANDLE && makeDevice(probe.surface()).ok();
    }
    return m_canPresent ? base::Done{} : makeDevice(VK_NULL_HANDLE);
}

base::Status GpuContext::makeDevice(VkSurfaceKHR surface) {
    // The window's own threads show what moves (decision 202).
    ASSIGN_OR_RETURN(Device device, Device::create(*m_instance, surface, render::gpu::DeviceThreads::StepBack));
    m_device = std::make_unique<Device>(std::move(device));
    return base::Done{};
}

}  // namespace ui
