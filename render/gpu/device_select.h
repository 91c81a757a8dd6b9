#pragma once

#include <utility>
#include <vector>

#include "render/gpu/check.h"
#include "render/gpu/device.h"

namespace render::gpu {

/// The colour and depth formats everything is drawn in. Both must be there with 1 sample; `Caps::canSmooth` says
/// whether also with 4.
inline constexpr VkFormat kColourFormat = VK_FORMAT_R8G8B8A8_SRGB;
/// Stencil marks the pixels a translucent layer has already coloured. D32S8 rather than D24S8: reversed z needs floats.
inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT_S8_UINT;

/// Everything about features, in one chain that starts at `core`.
struct Features {
    VkPhysicalDeviceMeshShaderFeaturesEXT mesh =
        vkInfo<VkPhysicalDeviceMeshShaderFeaturesEXT>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MESH_SHADER_FEATURES_EXT);
    VkPhysicalDeviceVulkan12Features v12 =
        vkInfo<VkPhysicalDeviceVulkan12Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    VkPhysicalDeviceVulkan13Features v13 =
        vkInfo<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
    VkPhysicalDeviceFeatures2 core = vkInfo<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);

    /// `mesh` is in the chain only where the device has the extension.
    explicit Features(bool hasMesh);
    Features(const Features&) = delete;
    Features& operator=(const Features&) = delete;

    /// Those that we cannot do without, by name.
    [[nodiscard]] std::vector<std::pair<const char*, VkBool32*>> needed();
};

[[nodiscard]] bool canPresent(VkPhysicalDevice device, std::uint32_t family, VkSurfaceKHR surface);

/// Errors: DeviceFailed, with what each device found lacks.
[[nodiscard]] base::Result<DeviceChoice> chooseDevice(VkInstance instance, VkSurfaceKHR presentTo);

}  // namespace render::gpu
