#pragma once

#include "render/gpu/device.h"

namespace render::gpu {

/// The colour and depth formats everything is drawn in. Both must be there with 1 sample; `Caps::canSmooth` says
/// whether also with 4.
inline constexpr VkFormat kColourFormat = VK_FORMAT_R8G8B8A8_SRGB;
/// Stencil marks the pixels a translucent layer has already coloured. D32S8 rather than D24S8: reversed z needs floats.
inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT_S8_UINT;

/// A physical device that can do all we need.
struct DeviceChoice {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    std::uint32_t queueFamily = 0;
    bool hasSwapchain = false;
    bool hasMemoryBudget = false;
    Caps caps;
};

/// Errors: DeviceFailed, with what each device found lacks.
[[nodiscard]] base::Result<DeviceChoice> chooseDevice(VkInstance instance, VkSurfaceKHR presentTo);

}  // namespace render::gpu
