#include "render/gpu/image.h"

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

Unique<VkImage> createImage(Device& device, const ImageOptions& options) {
    auto info = vkInfo<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = options.format;
    info.extent = {options.extent.width, options.extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = options.samples;
    info.usage = options.usage;
    VkImage handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateImage(device.handle(), &info, nullptr, &handle));
    return {device, handle, options.label};
}

Unique<VkImageView> createView(Device& device, VkImage image, const ImageOptions& options) {
    auto info = vkInfo<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = options.format;
    info.subresourceRange = {options.aspect, 0, 1, 0, 1};
    VkImageView handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateImageView(device.handle(), &info, nullptr, &handle));
    return {device, handle, options.label};
}

}  // namespace

Image::Image(Device& device, const ImageOptions& options) : m_handle(createImage(device, options)) {
    MemoryOptions memory;
    vkGetImageMemoryRequirements(device.handle(), handle(), &memory.requirements);
    memory.wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    memory.use = MemoryUse::Targets;
    memory.label = options.label;
    m_memory = Memory(device, memory);
    VK_CHECK(vkBindImageMemory(device.handle(), handle(), m_memory.part().memory, m_memory.part().offset));
    m_view = createView(device, handle(), options);
}

}  // namespace render::gpu
