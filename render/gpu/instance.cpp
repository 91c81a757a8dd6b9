#include "render/gpu/instance.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

base::Error deviceError(std::string text) {
    return {base::ErrorCode::DeviceFailed, std::move(text)};
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto& sink = *static_cast<MessageSink*>(user);
    if ((severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) == 0) {
        spdlog::warn("Vulkan: {}", data->pMessage);
        return VK_FALSE;
    }
    ++sink.errors;
    spdlog::error("Vulkan: {}", data->pMessage);
    if (sink.aborts) {
        spdlog::shutdown();
        std::abort();
    }
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageSink& sink) {
    auto info = vkInfo<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // Not GENERAL: the loader reports every driver it could not open there, which is no fault of ours.
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = onMessage;
    info.pUserData = &sink;
    return info;
}

Validation resolve(Validation wanted) {
    if (wanted != Validation::FromEnvironment) {
        return wanted;
    }
    const char* value = std::getenv("COPPERSCOPE_VALIDATION");
    if (value == nullptr) {
        return Validation::Off;
    }
    const std::string_view text(value);
    return text == "abort" ? Validation::Abort : text == "log" ? Validation::Log : Validation::Off;
}

bool hasLayer(const char* name) {
    const auto layers = listOf<VkLayerProperties>(vkEnumerateInstanceLayerProperties);
    return std::ranges::any_of(layers, [&](const auto& l) { return std::strcmp(l.layerName, name) == 0; });
}

bool hasExtension(const std::string& name) {
    const auto extensions = listOf<VkExtensionProperties>(vkEnumerateInstanceExtensionProperties, nullptr);
    return std::ranges::any_of(extensions, [&](const auto& e) { return name == e.extensionName; });
}

std::string explain(VkResult result) {
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
        return kNoDriver;
    }
    return std::string("Vulkan could not be started: ") + toString(result) + ".";
}

}  // namespace

Instance::State::~State() {
    if (messenger != VK_NULL_HANDLE) {
        destroyMessenger(handle, messenger, nullptr);
    }
    if (handle != VK_NULL_HANDLE) {
        vkDestroyInstance(handle, nullptr);
    }
}

void Instance::State::listen() {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(handle, "vkCreateDebugUtilsMessengerEXT"));
    destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(handle, "vkDestroyDebugUtilsMessengerEXT"));
    const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(sink);
    VK_CHECK(create(handle, &info, nullptr, &messenger));
}

base::Result<Instance> Instance::create(const InstanceOptions& options) {
    std::uint32_t version = VK_API_VERSION_1_0;
    if (vkEnumerateInstanceVersion(&version) != VK_SUCCESS || version < VK_API_VERSION_1_3) {
        return deviceError("The Vulkan loader of this machine is older than 1.3.");
    }
    auto state = std::make_unique<State>();
    const Validation validation = resolve(options.validation);
    const bool isValidated = validation != Validation::Off && hasLayer(kValidationLayer);
    if (validation != Validation::Off && !isValidated) {
        spdlog::warn("Vulkan validation was requested, but {} is not installed.", kValidationLayer);
    }
    state->sink.aborts = validation == Validation::Abort;
    state->hasDebugUtils = isValidated || hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    std::vector<const char*> extensions;
    for (const std::string& name : options.extensions) {
        if (!hasExtension(name)) {
            return deviceError("The Vulkan loader of this machine lacks " + name + ".");
        }
        extensions.push_back(name.c_str());
        state->hasSurfaces = state->hasSurfaces || name == VK_KHR_SURFACE_EXTENSION_NAME;
    }
    if (state->hasDebugUtils) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }

    auto app = vkInfo<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    app.pApplicationName = options.appName.c_str();
    app.apiVersion = VK_API_VERSION_1_3;
    const VkDebugUtilsMessengerCreateInfoEXT messages = messengerInfo(state->sink);
    auto info = vkInfo<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &app;
    info.pNext = isValidated ? &messages : nullptr;  // hears vkCreateInstance itself
    info.enabledLayerCount = isValidated ? 1 : 0;
    info.ppEnabledLayerNames = &kValidationLayer;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (const VkResult result = vkCreateInstance(&info, nullptr, &state->handle); result != VK_SUCCESS) {
        state->handle = VK_NULL_HANDLE;
        return deviceError(explain(result));
    }
    if (isValidated) {
        state->listen();
    }
    return Instance(std::move(state));
}

}  // namespace render::gpu
