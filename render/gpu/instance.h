#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/base/result.h"

/// Vulkan without boards: devices, memory, pipelines, frames. Knows neither documents nor Qt.
namespace render::gpu {

enum class Validation : std::uint8_t {
    Off,
    Log,    ///< errors go to the log and are counted
    Abort,  ///< an error ends the program: for tests
    /// COPPERSCOPE_VALIDATION=log or =abort; off when unset.
    FromEnvironment
};

/// What is said where no driver is installed.
inline constexpr const char* kNoDriver =
    "No Vulkan driver was found. Install the driver of the graphics card, or mesa-vulkan-drivers for a software "
    "device.";

struct InstanceOptions {
    std::string appName = "copperscope";
    std::vector<std::string> extensions;  ///< surface extensions of the window system; none to draw offscreen only
    Validation validation = Validation::FromEnvironment;
};

/// How messages of the validation layer are treated, and how many errors there were. Lives as long as the messenger.
struct MessageSink {
    bool aborts = false;
    std::atomic<std::uint32_t> errors{0};
};

/// The connection to the machine's Vulkan drivers. Needs no display. Move-only; outlives every Device made from it.
class Instance {
public:
    /// Errors: DeviceFailed when there is no Vulkan loader or driver, when it is older than 1.3, or when an extension
    /// requested is missing. A missing validation layer is no error: a warning goes to the log.
    [[nodiscard]] static base::Result<Instance> create(const InstanceOptions& options);

    [[nodiscard]] VkInstance handle() const { return m_state->handle; }
    /// Whether debug labels reach anybody (VK_EXT_debug_utils is on).
    [[nodiscard]] bool hasDebugUtils() const { return m_state->hasDebugUtils; }
    /// Whether surfaces of windows can be made (VK_KHR_surface was requested).
    [[nodiscard]] bool hasSurfaces() const { return m_state->hasSurfaces; }
    /// Validation errors seen so far.
    [[nodiscard]] std::uint32_t validationErrors() const { return m_state->sink.errors; }

private:
    struct State {
        VkInstance handle = VK_NULL_HANDLE;
        VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
        PFN_vkDestroyDebugUtilsMessengerEXT destroyMessenger = nullptr;
        bool hasDebugUtils = false;
        bool hasSurfaces = false;
        MessageSink sink;

        State() = default;
        State(const State&) = delete;
        State& operator=(const State&) = delete;
        ~State();
        void listen();
    };
    explicit Instance(std::unique_ptr<State> state) : m_state(std::move(state)) {}
    std::unique_ptr<State> m_state;
};

}  // namespace render::gpu
