#pragma once

#include <vulkan/vulkan.h>

namespace render::gpu {

/// A pipeline stage with what it does to memory.
struct Access {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
};

inline constexpr VkPipelineStageFlags2 kAllStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
inline constexpr Access kCopyWrite{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
inline constexpr Access kCopyRead{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr Access kCompute{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                 VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT};
inline constexpr Access kColour{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
inline constexpr Access kDepth{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
inline constexpr Access kAnyRead{kAllStages, VK_ACCESS_2_MEMORY_READ_BIT};
inline constexpr Access kAnything{kAllStages, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
inline constexpr Access kHostRead{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT};

/// What `after` does sees all that `before` did. Buffers need no finer barriers: drivers treat them the same.
void memoryBarrier(VkCommandBuffer commands, Access before, Access after);

struct ImageTransition {
    VkImage image = VK_NULL_HANDLE;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageLayout from = VK_IMAGE_LAYOUT_UNDEFINED;  ///< UNDEFINED drops the contents
    VkImageLayout to = VK_IMAGE_LAYOUT_UNDEFINED;
    Access before;
    Access after;
};
void imageBarrier(VkCommandBuffer commands, const ImageTransition& transition);

/// Copies the colours of an image in TRANSFER_SRC layout to one in TRANSFER_DST layout.
void copyImage(VkCommandBuffer commands, VkImage from, VkImage to, VkExtent2D extent);

}  // namespace render::gpu
