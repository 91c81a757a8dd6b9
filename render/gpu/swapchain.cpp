#include "render/gpu/swapchain.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "render/gpu/check.h"

namespace render::gpu {
namespace {

/// More than frames in flight: a semaphore returns to duty only when its frame is long done.
constexpr std::size_t kAvailableCount = 3;

/// Some window systems give no image while a window is hidden: then the frame is skipped rather than the program
/// stopped.
constexpr std::uint64_t kPatienceNs = 500'000'000;

struct FormatPair {
    VkFormat surface;
    VkFormat drawn;
};
constexpr FormatPair kFormats[] = {
    {VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_B8G8R8A8_SRGB},
    {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB},
    {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_B8G8R8A8_SRGB},
    {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_SRGB},
};

/// The first of our pairs the surface offers; none if it offers no 8-bit sRGB at all.
bool chooseFormat(const std::vector<VkSurfaceFormatKHR>& offered, VkSurfaceFormatKHR& format, VkFormat& drawn) {
    for (const FormatPair& pair : kFormats) {
        for (const VkSurfaceFormatKHR& candidate : offered) {
            if (candidate.format == pair.surface && candidate.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) {
                format = candidate;
                drawn = pair.drawn;
                return true;
            }
        }
    }
    return false;
}

Unique<VkSemaphore> createSemaphore(Device& device) {
    auto info = vkInfo<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    VkSemaphore handle = VK_NULL_HANDLE;
    VK_CHECK(vkCreateSemaphore(device.handle(), &info, nullptr, &handle));
    return {device, handle, "swapchain"};
}

VkCompositeAlphaFlagBitsKHR compositeAlpha(VkCompositeAlphaFlagsKHR supported) {
    return (supported & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0 ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                                                                : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
}

/// How many images to request: one more than the least, so that drawing need not wait for the display; at most what the
/// surface allows (0 = any).
std::uint32_t imageCount(const VkSurfaceCapabilitiesKHR& caps) {
    const std::uint32_t wanted = caps.minImageCount + 1;
    return caps.maxImageCount == 0 ? wanted : std::min(wanted, caps.maxImageCount);
}

}  // namespace

Swapchain::Swapchain(Device& device, VkSurfaceKHR surface) : m_device(&device), m_surface(surface) {
    const auto offered = listOf<VkSurfaceFormatKHR>(vkGetPhysicalDeviceSurfaceFormatsKHR, device.physical(), surface);
    if (!chooseFormat(offered, m_format, m_drawFormat)) {
        spdlog::error("The window's surface offers no 8-bit sRGB format; nothing can be drawn in it.");
    }
    for (std::size_t i = 0; i < kAvailableCount; ++i) {
        m_available.push_back(createSemaphore(device));
    }
}

Swapchain::~Swapchain() {
    if (m_handle) {
        drop();
    }
}

void Swapchain::drop() {
    m_images.clear();
    m_finished.clear();
    m_handle.reset();
    m_extent = {};
    m_device->waitIdle();  // frees it before the surface can go
}

void Swapchain::resize(VkExtent2D size) {
    m_wanted = size;
}

bool Swapchain::remake() {
    VkSurfaceCapabilitiesKHR caps{};
    if (m_drawFormat == VK_FORMAT_UNDEFINED ||
        vkGetPhysicalDeviceSurfaceCapabilitiesKHR(m_device->physical(), m_surface, &caps) != VK_SUCCESS ||
        (caps.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) == 0) {
        return false;
    }
    constexpr std::uint32_t kSizeIsOurs = 0xffffffff;
    VkExtent2D extent = caps.currentExtent.width == kSizeIsOurs ? m_wanted : caps.currentExtent;
    if (extent.width == 0 || extent.height == 0 || m_wanted.width == 0 || m_wanted.height == 0) {
        return false;
    }
    extent = {std::clamp(extent.width, caps.minImageExtent.width, caps.maxImageExtent.width),
              std::clamp(extent.height, caps.minImageExtent.height, caps.maxImageExtent.height)};
    m_device->waitIdle();

    auto info = vkInfo<VkSwapchainCreateInfoKHR>(VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR);
    info.surface = m_surface;
    info.minImageCount = imageCount(caps);
    info.imageFormat = m_format.format;
    info.imageColorSpace = m_format.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = caps.currentTransform;
    info.compositeAlpha = compositeAlpha(caps.supportedCompositeAlpha);
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = m_handle.get();
    VkSwapchainKHR handle = VK_NULL_HANDLE;
    const VkResult result = vkCreateSwapchainKHR(m_device->handle(), &info, nullptr, &handle);
    m_device->noteLoss(result);
    if (result != VK_SUCCESS) {
        return false;  // the window is going or being resized again: the next frame tries anew
    }
    drop();
    m_handle = {*m_device, handle, "swapchain"};
    m_extent = extent;
    m_requested = m_wanted;
    m_isStale = false;
    createImages();
    return true;
}

void Swapchain::createImages() {
    std::uint32_t count = 0;
    VK_CHECK(vkGetSwapchainImagesKHR(m_device->handle(), m_handle.get(), &count, nullptr));
    m_images.resize(count);
    VK_CHECK(vkGetSwapchainImagesKHR(m_device->handle(), m_handle.get(), &count, m_images.data()));
    for (std::uint32_t i = 0; i < count; ++i) {
        m_finished.push_back(createSemaphore(*m_device));
    }
}

Swapchain::Outcome Swapchain::makeReady() {
    const bool isResized = m_wanted.width != m_requested.width || m_wanted.height != m_requested.height;
    if ((m_isStale || isResized || !m_handle) && !remake()) {
        return m_device->isLost() ? Outcome::DeviceLost : Outcome::Skipped;
    }
    return Outcome::Done;
}

Swapchain::Outcome Swapchain::acquire(Target& target) {
    m_next = (m_next + 1) % m_available.size();
    target.available = m_available[m_next].get();
    const VkResult result = vkAcquireNextImageKHR(m_device->handle(), m_handle.get(), kPatienceNs, target.available,
                                                  VK_NULL_HANDLE, &target.index);
    if (m_device->noteLoss(result)) {
        return Outcome::DeviceLost;
    }
    if (result != VK_SUCCESS && result != VK_SUBOPTIMAL_KHR) {
        m_isStale = result < VK_SUCCESS;  // not when it only took too long
        return Outcome::Skipped;
    }
    m_isStale = result == VK_SUBOPTIMAL_KHR;
    target.image = m_images[target.index];
    target.finished = m_finished[target.index].get();
    return Outcome::Done;
}

Swapchain::Outcome Swapchain::present(const Target& target) {
    const VkSwapchainKHR handle = m_handle.get();
    auto info = vkInfo<VkPresentInfoKHR>(VK_STRUCTURE_TYPE_PRESENT_INFO_KHR);
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &target.finished;
    info.swapchainCount = 1;
    info.pSwapchains = &handle;
    info.pImageIndices = &target.index;
    const VkResult result = vkQueuePresentKHR(m_device->queue(), &info);
    if (m_device->noteLoss(result)) {
        return Outcome::DeviceLost;
    }
    m_isStale = m_isStale || result != VK_SUCCESS;
    return result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR ? Outcome::Done : Outcome::Skipped;
}

}  // namespace render::gpu
