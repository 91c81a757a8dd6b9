#pragma once

#include "render/gpu/deferred_destroy.h"
#include "render/gpu/memory.h"

namespace render::gpu {

struct ImageOptions {
    std::string_view label;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{};
    VkImageUsageFlags usage = 0;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

/// A 2D image to draw to, with one view of it.
class Image {
public:
    Image() = default;
    Image(Device& device, const ImageOptions& options);

    [[nodiscard]] VkImage handle() const { return m_handle.get(); }
    [[nodiscard]] VkImageView view() const { return m_view.get(); }
    explicit operator bool() const { return static_cast<bool>(m_handle); }

private:
    Memory m_memory;
    Unique<VkImage> m_handle;
    Unique<VkImageView> m_view;
};

}  // namespace render::gpu
