#pragma once

#include <vulkan/vulkan.h>

namespace render::gpu {

/// A zeroed Vulkan structure that says what it is. (Brace initialisation of the first member alone is a warning to
/// GCC.)
template <class Info>
constexpr Info vkInfo(VkStructureType type) {
    Info info{};
    info.sType = type;
    return info;
}

}  // namespace render::gpu
