#include "render/gpu/graveyard.h"

namespace render::gpu {
namespace {

template <class Handle>
Handle as(std::uint64_t handle) {
    return reinterpret_cast<Handle>(handle);
}

}  // namespace

void Graveyard::collect(std::uint64_t done) {
    while (!m_retired.empty() && m_retired.front().after <= done) {
        destroy(m_retired.front());
        m_retired.pop_front();
    }
}

void Graveyard::destroy(const Retired& object) {
    const std::uint64_t h = object.handle;
    switch (object.type) {
        case VK_OBJECT_TYPE_BUFFER: vkDestroyBuffer(m_device, as<VkBuffer>(h), nullptr); break;
        case VK_OBJECT_TYPE_IMAGE: vkDestroyImage(m_device, as<VkImage>(h), nullptr); break;
        case VK_OBJECT_TYPE_IMAGE_VIEW: vkDestroyImageView(m_device, as<VkImageView>(h), nullptr); break;
        case VK_OBJECT_TYPE_PIPELINE: vkDestroyPipeline(m_device, as<VkPipeline>(h), nullptr); break;
        case VK_OBJECT_TYPE_PIPELINE_LAYOUT: vkDestroyPipelineLayout(m_device, as<VkPipelineLayout>(h), nullptr); break;
        case VK_OBJECT_TYPE_SHADER_MODULE: vkDestroyShaderModule(m_device, as<VkShaderModule>(h), nullptr); break;
        case VK_OBJECT_TYPE_COMMAND_POOL: vkDestroyCommandPool(m_device, as<VkCommandPool>(h), nullptr); break;
        case VK_OBJECT_TYPE_QUERY_POOL: vkDestroyQueryPool(m_device, as<VkQueryPool>(h), nullptr); break;
        case VK_OBJECT_TYPE_SEMAPHORE: vkDestroySemaphore(m_device, as<VkSemaphore>(h), nullptr); break;
        case VK_OBJECT_TYPE_SWAPCHAIN_KHR: vkDestroySwapchainKHR(m_device, as<VkSwapchainKHR>(h), nullptr); break;
        case VK_OBJECT_TYPE_DEVICE_MEMORY:
            noteFree(h);
            vkFreeMemory(m_device, as<VkDeviceMemory>(h), nullptr);
            break;
        default: ASSERT(false);  // kObjectType has no other
    }
}

void Graveyard::noteAllocation(VkDeviceMemory memory, MemoryUse use, std::uint64_t bytes) {
    m_allocations[reinterpret_cast<std::uint64_t>(memory)] = {use, bytes};
    m_report.bytes[static_cast<std::size_t>(use)] += bytes;
}

void Graveyard::noteFree(std::uint64_t memory) {
    const auto found = m_allocations.find(memory);
    ASSERT(found != m_allocations.end());
    m_report.bytes[static_cast<std::size_t>(found->second.use)] -= found->second.bytes;
    m_allocations.erase(found);
}

}  // namespace render::gpu
