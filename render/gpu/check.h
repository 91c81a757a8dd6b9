#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <vector>

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

/// A zeroed Vulkan structure that says what it is. (Brace initialisation of the first member alone is a warning to
/// GCC.)
template <class Info>
constexpr Info vkInfo(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

/// All that one of Vulkan's enumerating functions lists; nothing where it fails.
template <class Item, class Enumerate, class... Arguments>
std::vector<Item> listOf(Enumerate enumerate, Arguments... arguments) {
    std::uint32_t count = 0;
    if (enumerate(arguments..., &count, nullptr) < VK_SUCCESS) {
        return {};
    }
    std::vector<Item> items(count);
    return enumerate(arguments..., &count, items.data()) < VK_SUCCESS ? std::vector<Item>() : items;
}

}  // namespace render::gpu

/// For every call whose failure has no path of its own (device loss and swapchain results have). Active in every build.
#define VK_CHECK(call)                                                         \
    do {                                                                       \
        const VkResult checkedResult = (call);                                 \
        if (checkedResult < VK_SUCCESS) {                                      \
            ::render::gpu::failCall(checkedResult, #call, __FILE__, __LINE__); \
        }                                                                      \
    } while (false)
