#pragma once

#include <vulkan/vulkan.h>

#include <string>

namespace render::gpu {

/// Thrown where the device or the machine has no memory left, at whatever depth. Everything that owns Vulkan objects
/// is destroyed on the way up; it stops at the doors of the renderer (BoardScene::make, the presenters), which return
/// a Result or draw with less.
struct OutOfMemory {
    std::string what;  ///< what there was no room for: "lets (12.5 MB)"
};

/// Throws OutOfMemory if that is what was returned. Anything else is logged and aborts: a result we have no path for
/// is our bug or a broken driver, and going on would draw nonsense.
[[noreturn]] void failCall(VkResult result, const char* call, const char* file, int line);

/// The name of a result code, "VK_ERROR_DEVICE_LOST".
[[nodiscard]] const char* toString(VkResult result);

}  // namespace render::gpu

/// For every call whose failure has no path of its own (device loss and swapchain results have). Active in every build.
#define VK_CHECK(call)                                                         \
    do {                                                                       \
        const VkResult checkedResult = (call);                                 \
        if (checkedResult < VK_SUCCESS) {                                      \
            ::render::gpu::failCall(checkedResult, #call, __FILE__, __LINE__); \
        }                                                                      \
    } while (false)
