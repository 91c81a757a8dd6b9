#include "render/frame/render_target.h"

#include "render/gpu/barrier.h"
#include "render/gpu/check.h"
#include "render/gpu/device_select.h"

namespace render {
namespace {

constexpr VkImageLayout kColourLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout kDepthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
constexpr VkImageAspectFlags kDepthAspects = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;

constexpr VkImageUsageFlags kDrawnDepth = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
constexpr VkImageUsageFlags kReadDepth = kDrawnDepth | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
constexpr VkImageLayout kReadLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
constexpr std::uint64_t kDepthBytes = 4;  // without stencil

VkRenderingAttachmentInfo attachment(const gpu::Image& image, VkImageLayout layout, VkAttachmentLoadOp load) {
    auto info = gpu::vkInfo<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    info.imageView = image.view();
    info.imageLayout = layout;
    info.loadOp = load;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;  // drawing may go on after a pause
    return info;
}

}  // namespace

bool fitsOn(const gpu::Caps& caps, VkExtent2D extent, VkSampleCountFlagBits samples) {
    constexpr std::uint64_t kColourBytes = 4;
    constexpr std::uint64_t kDepthBytes = 8;  // 32-bit depth and stencil, padded
    const std::uint64_t pixels = std::uint64_t{extent.width} * extent.height;
    const std::uint64_t largest = pixels * samples * kDepthBytes;
    const std::uint64_t total = pixels * kColourBytes + pixels * samples * (kColourBytes + kDepthBytes);
    return largest <= caps.maxAllocationBytes && total < caps.memoryBudgetBytes;
}

bool RenderTarget::is(VkExtent2D extent, const TargetFormat& format) const {
    return extent.width == m_extent.width && extent.height == m_extent.height && format == m_format;
}

void RenderTarget::setSize(VkExtent2D extent, const TargetFormat& format) {
    if (is(extent, format)) {
        return;
    }
    m_extent = {};  // nothing is whole until all of it is made
    m_colour = gpu::Image();
    m_samples = gpu::Image();
    m_depth = gpu::Image();
    m_cached = gpu::Image();
    m_flatDepth = gpu::Image();
    m_depths = gpu::Buffer();
    m_hasDepth = false;
    m_colour = gpu::Image(*m_device, {"colour", format.colour, extent,
                                      VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                          VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (format.samples != VK_SAMPLE_COUNT_1_BIT) {
        m_samples = gpu::Image(*m_device,
                               {"samples", format.colour, extent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, format.samples});
    }
    m_depth = gpu::Image(
        *m_device, {"depth", gpu::kDepthFormat, extent,
                    format.samples == VK_SAMPLE_COUNT_1_BIT ? kReadDepth : kDrawnDepth, format.samples, kDepthAspects});
    m_extent = extent;
    m_format = format;
}

void RenderTarget::makeReady(VkCommandBuffer commands) const {
    // What was there is dropped; the last frame may still be copying from it or drawing to it.
    gpu::imageBarrier(commands, {m_colour.handle(), VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED, kColourLayout,
                                 gpu::kAnything, gpu::kColour});
    if (isSmoothed()) {
        gpu::imageBarrier(commands, {m_samples.handle(), VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                                     kColourLayout, gpu::kColour, gpu::kColour});
    }
    gpu::imageBarrier(
        commands, {m_depth.handle(), kDepthAspects, VK_IMAGE_LAYOUT_UNDEFINED, kDepthLayout, gpu::kDepth, gpu::kDepth});
}

void RenderTarget::begin(VkCommandBuffer commands, const glm::vec3& background) {
    m_hasDepth = false;
    makeReady(commands);
    start(commands, VK_ATTACHMENT_LOAD_OP_CLEAR, background);
}

void RenderTarget::resume(VkCommandBuffer commands) const {
    gpu::memoryBarrier(commands, gpu::kColour, gpu::kColour);
    gpu::memoryBarrier(commands, gpu::kDepth, gpu::kDepth);
    start(commands, VK_ATTACHMENT_LOAD_OP_LOAD, {});
}

/// Sample 0 of every pixel, which every device can.
void RenderTarget::flattenDepth(VkCommandBuffer commands) const {
    gpu::imageBarrier(commands, {m_flatDepth.handle(), kDepthAspects, VK_IMAGE_LAYOUT_UNDEFINED, kDepthLayout,
                                 gpu::kAnything, gpu::kAnything});
    gpu::memoryBarrier(commands, gpu::kDepth, gpu::kAnything);
    VkRenderingAttachmentInfo depth = attachment(m_depth, kDepthLayout, VK_ATTACHMENT_LOAD_OP_LOAD);
    depth.resolveMode = VK_RESOLVE_MODE_SAMPLE_ZERO_BIT;
    depth.resolveImageView = m_flatDepth.view();
    depth.resolveImageLayout = kDepthLayout;
    auto info = gpu::vkInfo<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = {{0, 0}, m_extent};
    info.layerCount = 1;
    info.pDepthAttachment = &depth;
    info.pStencilAttachment = &depth;
    vkCmdBeginRendering(commands, &info);
    vkCmdEndRendering(commands);
}

void RenderTarget::keepDepth(VkCommandBuffer commands) {
    if (m_depths.size() == 0) {
        m_depths = gpu::Buffer(*m_device,
                               {"kept depth", kDepthBytes * m_extent.width * m_extent.height, gpu::MemoryUse::Targets});
    }
    if (isSmoothed() && !m_flatDepth) {
        m_flatDepth = gpu::Image(
            *m_device, {"kept depth", gpu::kDepthFormat, m_extent, kReadDepth, VK_SAMPLE_COUNT_1_BIT, kDepthAspects});
    }
    pause(commands);
    if (isSmoothed()) {
        flattenDepth(commands);
    }
    const gpu::Image& flat = isSmoothed() ? m_flatDepth : m_depth;
    gpu::imageBarrier(commands,
                      {flat.handle(), kDepthAspects, kDepthLayout, kReadLayout, gpu::kAnything, gpu::kAnything});
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, 1};
    region.imageExtent = {m_extent.width, m_extent.height, 1};
    vkCmdCopyImageToBuffer(commands, flat.handle(), kReadLayout, m_depths.handle(), 1, &region);
    gpu::imageBarrier(commands,
                      {flat.handle(), kDepthAspects, kReadLayout, kDepthLayout, gpu::kCopyRead, gpu::kAnything});
    gpu::memoryBarrier(commands, gpu::kCopyWrite, gpu::kAnyRead);
    m_hasDepth = true;
    resume(commands);
}

void RenderTarget::beginRendering(VkCommandBuffer commands, const VkRenderingAttachmentInfo& colour,
                                  const VkRenderingAttachmentInfo* depth) const {
    auto info = gpu::vkInfo<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = {{0, 0}, m_extent};
    info.layerCount = 1;
    info.colorAttachmentCount = 1;
    info.pColorAttachments = &colour;
    info.pDepthAttachment = depth;
    info.pStencilAttachment = depth;
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport{0.0F, 0.0F, static_cast<float>(m_extent.width), static_cast<float>(m_extent.height),
                              0.0F, 1.0F};
    const VkRect2D area{{0, 0}, m_extent};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    gpu::Pipeline::setFrontFace(commands, false);
}

void RenderTarget::beginOver(VkCommandBuffer commands) const {
    gpu::imageBarrier(commands, {m_colour.handle(), VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                 kColourLayout, gpu::kAnything, gpu::kColour});
    beginRendering(commands, attachment(m_colour, kColourLayout, VK_ATTACHMENT_LOAD_OP_LOAD), nullptr);
}

void RenderTarget::copy(VkCommandBuffer commands, VkImage from, VkImage to) const {
    gpu::imageBarrier(commands, {to, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, gpu::kAnything, gpu::kCopyWrite});
    gpu::copyImage(commands, from, to, m_extent);
    gpu::imageBarrier(commands, {to, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, gpu::kCopyWrite, gpu::kCopyRead});
}

void RenderTarget::cacheBoard(VkCommandBuffer commands) {
    if (!m_cached) {
        m_cached = gpu::Image(*m_device, {"cached picture", m_format.colour, m_extent,
                                          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                              VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    }
    copy(commands, m_colour.handle(), m_cached.handle());
}

void RenderTarget::restore(VkCommandBuffer commands) const {
    copy(commands, m_cached.handle(), m_colour.handle());
}

bool RenderTarget::hasCached(VkExtent2D extent, VkFormat colour) const {
    return m_cached && extent.width == m_extent.width && extent.height == m_extent.height && colour == m_format.colour;
}

void RenderTarget::start(VkCommandBuffer commands, VkAttachmentLoadOp load, const glm::vec3& background) const {
    VkRenderingAttachmentInfo colour = attachment(isSmoothed() ? m_samples : m_colour, kColourLayout, load);
    colour.clearValue.color = {{background.r, background.g, background.b, 1.0F}};
    if (isSmoothed()) {
        colour.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
        colour.resolveImageView = m_colour.view();
        colour.resolveImageLayout = kColourLayout;
    }
    VkRenderingAttachmentInfo depth = attachment(m_depth, kDepthLayout, load);
    depth.clearValue.depthStencil = {0.0F, 0};  // reversed: 0 is farthest
    beginRendering(commands, colour, &depth);
}

void RenderTarget::end(VkCommandBuffer commands) const {
    vkCmdEndRendering(commands);
    gpu::imageBarrier(commands, {m_colour.handle(), VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, gpu::kColour, gpu::kCopyRead});
}

}  // namespace render
