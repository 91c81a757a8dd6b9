#pragma once

#include <vulkan/vulkan.h>

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

struct InstanceOptions {
    std::string appName = "copperscope";
    std::vector<std::string> extensions;  ///< surface extensions of the window system; none to draw offscreen only
    Validation validation = Validation::FromEnvironment;
};

/// The connection to the machine's Vulkan drivers. Needs no display. Move-only; outlives every Device made from it.
class Instance {
public:
    /// Errors: DeviceFailed when there is no Vulkan loader or driver, when it is older than 1.3, or when an extension
    /// requested is missing. A missing validation layer is no error: a warning goes to the log.
    [[nodiscard]] static base::Result<Instance> create(const InstanceOptions& options);
    ~Instance();
    Instance(Instance&&) noexcept;
    Instance& operator=(Instance&&) noexcept;

    [[nodiscard]] VkInstance handle() const;
    /// Whether debug labels reach anybody (VK_EXT_debug_utils is on).
    [[nodiscard]] bool hasDebugUtils() const;
    /// Whether surfaces of windows can be made (VK_KHR_surface was requested).
    [[nodiscard]] bool hasSurfaces() const;
    /// Validation errors seen so far.
    [[nodiscard]] std::uint32_t validationErrors() const;

private:
    struct State;
    explicit Instance(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace render::gpu
