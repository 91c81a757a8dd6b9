#include "render/gpu/device_select.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

using Extensions = std::vector<VkExtensionProperties>;

bool has(const Extensions& extensions, const char* name) {
    return std::ranges::any_of(extensions, [&](const auto& e) { return std::strcmp(e.extensionName, name) == 0; });
}

VkPhysicalDeviceProperties propertiesOf(VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    return properties;
}

struct Family {
    std::uint32_t index = 0;
    bool hasTimestamps = false;
};

/// One family that draws, computes and, when requested, presents: all hardware we know has it first in its list.
std::optional<Family> findFamily(VkPhysicalDevice device, VkSurfaceKHR presentTo) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & kNeeded) == kNeeded &&
            (presentTo == VK_NULL_HANDLE || canPresent(device, i, presentTo))) {
            return Family{i, families[i].timestampValidBits > 0};
        }
    }
    return std::nullopt;
}

VkSampleCountFlags samplesOf(VkPhysicalDevice device, VkFormat format, VkImageUsageFlags usage) {
    VkImageFormatProperties properties{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(device, format, VK_IMAGE_TYPE_2D,
                                                                     VK_IMAGE_TILING_OPTIMAL, usage, 0, &properties);
    return result == VK_SUCCESS ? properties.sampleCounts : 0;
}

std::uint64_t memoryBudget(VkPhysicalDevice device, bool hasBudget) {
    auto budget = vkInfo<VkPhysicalDeviceMemoryBudgetPropertiesEXT>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT);
    auto memory = vkInfo<VkPhysicalDeviceMemoryProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2);
    memory.pNext = hasBudget ? &budget : nullptr;
    vkGetPhysicalDeviceMemoryProperties2(device, &memory);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i) {
        const VkMemoryHeap& heap = memory.memoryProperties.memoryHeaps[i];
        if ((heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0) {
            largest = std::max(largest, hasBudget ? budget.heapBudget[i] : heap.size);
        }
    }
    return largest;
}

PipelineCacheOwner cacheOwnerOf(const VkPhysicalDeviceProperties& core, VkDriverId driver) {
    PipelineCacheOwner owner;
    owner.vendor = core.vendorID;
    owner.device = core.deviceID;
    owner.driver = static_cast<std::uint32_t>(driver);
    owner.driverVersion = core.driverVersion;
    static_assert(sizeof owner.cacheUuid == sizeof core.pipelineCacheUUID);
    std::ranges::copy(core.pipelineCacheUUID, owner.cacheUuid.begin());
    return owner;
}

Caps capsOf(VkPhysicalDevice device, const Extensions& extensions, bool hasMesh) {
    auto mesh =
        vkInfo<VkPhysicalDeviceMeshShaderPropertiesEXT>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MESH_SHADER_PROPERTIES_EXT);
    auto driver = vkInfo<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto sizes =
        vkInfo<VkPhysicalDeviceMaintenance3Properties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES);
    driver.pNext = &sizes;
    sizes.pNext = hasMesh ? &mesh : nullptr;
    auto all = vkInfo<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    all.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &all);
    const VkPhysicalDeviceProperties& core = all.properties;
    constexpr VkSampleCountFlags kSmooth = VK_SAMPLE_COUNT_4_BIT;
    Caps caps;
    caps.name = core.deviceName;
    caps.driver = std::string(driver.driverName) + " " + driver.driverInfo;
    caps.isCpu = core.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    caps.hasMeshShader = hasMesh;
    caps.timestampPeriodNs = static_cast<double>(core.limits.timestampPeriod);
    caps.canSmooth = (samplesOf(device, kColourFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) &
                      samplesOf(device, kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) & kSmooth) != 0;
    caps.maxImageSize = std::min({core.limits.maxImageDimension2D, core.limits.maxFramebufferWidth,
                                  core.limits.maxFramebufferHeight, core.limits.maxViewportDimensions[0]});
    caps.maxTaskGroups = hasMesh ? mesh.maxTaskWorkGroupCount[0] : 0;
    caps.maxAllocationBytes = sizes.maxMemoryAllocationSize;
    caps.cacheOwner = cacheOwnerOf(core, driver.driverID);
    caps.memoryBudgetBytes = memoryBudget(device, has(extensions, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME));
    return caps;
}

/// The choice this device would be, or in `why` what it lacks.
std::optional<DeviceChoice> examine(VkPhysicalDevice device, VkSurfaceKHR presentTo, std::string& why) {
    if (propertiesOf(device).apiVersion < VK_API_VERSION_1_3) {
        why = "has no Vulkan 1.3";
        return std::nullopt;
    }
    const auto extensions = listOf<VkExtensionProperties>(vkEnumerateDeviceExtensionProperties, device, nullptr);
    const bool hasMeshExtension = has(extensions, VK_EXT_MESH_SHADER_EXTENSION_NAME);
    Features features(hasMeshExtension);
    vkGetPhysicalDeviceFeatures2(device, &features.core);
    for (const auto& [name, isThere] : features.needed()) {
        if (*isThere == VK_FALSE) {
            why = std::string("lacks ") + name;
            return std::nullopt;
        }
    }
    if (samplesOf(device, kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) == 0) {
        why = "lacks 32-bit depth with stencil";
        return std::nullopt;
    }
    DeviceChoice choice;
    choice.hasSwapchain = has(extensions, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const std::optional<Family> family = findFamily(device, presentTo);
    if (!family || (presentTo != VK_NULL_HANDLE && !choice.hasSwapchain)) {
        why = presentTo != VK_NULL_HANDLE ? "cannot draw to this window" : "cannot draw";
        return std::nullopt;
    }
    choice.physical = device;
    choice.queueFamily = family->index;
    choice.caps = capsOf(device, extensions, hasMeshExtension && features.mesh.taskShader && features.mesh.meshShader);
    choice.caps.hasTimestamps = family->hasTimestamps;
    choice.caps.hasAtomic64 =
        features.core.features.shaderInt64 == VK_TRUE && features.v12.shaderBufferInt64Atomics == VK_TRUE;
    choice.caps.canShadeSamples = features.core.features.sampleRateShading == VK_TRUE;
    return choice;
}

/// Discrete before integrated before virtual before software.
int rank(VkPhysicalDevice device) {
    switch (propertiesOf(device).deviceType) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU: return 3;
        default: return 4;
    }
}

/// None too where the only driver found does not work: some loaders then answer "initialization failed".
std::vector<VkPhysicalDevice> allDevices(VkInstance instance) {
    auto devices = listOf<VkPhysicalDevice>(vkEnumeratePhysicalDevices, instance);
    std::ranges::stable_sort(devices, {}, rank);
    return devices;
}

}  // namespace

Features::Features(bool hasMesh) {
    v12.pNext = hasMesh ? &mesh : nullptr;
    v13.pNext = &v12;
    core.pNext = &v13;
}

std::vector<std::pair<const char*, VkBool32*>> Features::needed() {
    return {{"multiDrawIndirect", &core.features.multiDrawIndirect},
            {"drawIndirectFirstInstance", &core.features.drawIndirectFirstInstance},
            {"drawIndirectCount", &v12.drawIndirectCount},
            {"bufferDeviceAddress", &v12.bufferDeviceAddress},
            {"scalarBlockLayout", &v12.scalarBlockLayout},
            {"timelineSemaphore", &v12.timelineSemaphore},
            {"dynamicRendering", &v13.dynamicRendering},
            {"synchronization2", &v13.synchronization2},
            {"maintenance4", &v13.maintenance4}};
}

bool canPresent(VkPhysicalDevice device, std::uint32_t family, VkSurfaceKHR surface) {
    VkBool32 supported = VK_FALSE;
    return vkGetPhysicalDeviceSurfaceSupportKHR(device, family, surface, &supported) == VK_SUCCESS &&
           supported == VK_TRUE;
}

base::Result<DeviceChoice> chooseDevice(VkInstance instance, VkSurfaceKHR presentTo) {
    const std::vector<VkPhysicalDevice> devices = allDevices(instance);
    if (devices.empty()) {
        return base::Error{base::ErrorCode::DeviceFailed, kNoDriver};
    }
    const char* wanted = std::getenv("COPPERSCOPE_DEVICE");
    std::string reasons;
    for (VkPhysicalDevice device : devices) {
        const std::string name = propertiesOf(device).deviceName;
        std::string why = std::string("is not the one that COPPERSCOPE_DEVICE names");
        if (wanted == nullptr || name.find(wanted) != std::string::npos) {
            if (std::optional<DeviceChoice> choice = examine(device, presentTo, why)) {
                return *choice;
            }
        }
        reasons += (reasons.empty() ? "" : "; ") + name + " " + why;
    }
    return base::Error{base::ErrorCode::DeviceFailed, "No Vulkan device can be used: " + reasons + "."};
}

}  // namespace render::gpu
