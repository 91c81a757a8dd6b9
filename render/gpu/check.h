#pragma once

#include <vulkan/vulkan.h>

namespace render::gpu {

/// Logs the failed call and aborts: an answer we have no path for is our bug or a broken driver, and going on would
/// draw nonsense.
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
