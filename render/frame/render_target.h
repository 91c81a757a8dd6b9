#pragma once

#include <glm/glm.hpp>

#include "render/backends/let_backend.h"
#include "render/gpu/buffer.h"
#include "render/gpu/image.h"

namespace render {

/// Whether colour and depth of this size and with so many samples per pixel fit on the device.
[[nodiscard]] bool fitsOn(const gpu::Caps& caps, VkExtent2D extent, VkSampleCountFlagBits samples);

/// Colour and depth of one view, remade when its size or smoothing changes.
class RenderTarget {
public:
    explicit RenderTarget(gpu::Device& device) : m_device(&device) {}

    /// Throws gpu::OutOfMemory; there is no target then.
    void setSize(VkExtent2D extent, const TargetFormat& format);
    [[nodiscard]] bool is(VkExtent2D extent, const TargetFormat& format) const;
    [[nodiscard]] VkExtent2D extent() const { return m_extent; }
    [[nodiscard]] const TargetFormat& format() const { return m_format; }

    /// Starts drawing on a cleared target; `background` is linear.
    void begin(VkCommandBuffer commands, const glm::vec3& background);
    /// Between these two other work may be recorded; what was drawn is kept.
    static void pause(VkCommandBuffer commands) { vkCmdEndRendering(commands); }
    void resume(VkCommandBuffer commands) const;
    /// Ends drawing and leaves the picture in `picture()`, ready to be copied from.
    void end(VkCommandBuffer commands) const;
    /// Goes on over a finished picture, with one sample and without depth, until `end`.
    void beginOver(VkCommandBuffer commands) const;

    /// While drawing: puts the depth that there is aside, of one sample per pixel, and goes on. It is there until the
    /// next `begin`. Throws gpu::OutOfMemory; drawing may go on.
    void keepDepth(VkCommandBuffer commands);
    [[nodiscard]] bool hasDepth() const { return m_hasDepth; }
    /// Rows from the top of 32-bit floats, nearer is greater; for shaders, after `end`.
    [[nodiscard]] VkDeviceAddress depths() const { return m_depths.address(); }

    /// Puts a copy of the finished picture aside. Throws gpu::OutOfMemory; nothing is kept then.
    void cacheBoard(VkCommandBuffer commands);
    /// Makes the copy the finished picture again.
    void restore(VkCommandBuffer commands) const;
    /// Is there one of this size and format?
    [[nodiscard]] bool hasCached(VkExtent2D extent, VkFormat colour) const;
    [[nodiscard]] VkImage picture() const { return m_colour.handle(); }

private:
    [[nodiscard]] bool isSmoothed() const { return m_format.samples != VK_SAMPLE_COUNT_1_BIT; }
    void makeReady(VkCommandBuffer commands) const;
    void beginRendering(VkCommandBuffer commands, const VkRenderingAttachmentInfo& colour,
                        const VkRenderingAttachmentInfo* depth) const;
    void flattenDepth(VkCommandBuffer commands) const;
    void copy(VkCommandBuffer commands, VkImage from, VkImage to) const;
    void start(VkCommandBuffer commands, VkAttachmentLoadOp load, const glm::vec3& background) const;

    gpu::Device* m_device;
    VkExtent2D m_extent{};
    TargetFormat m_format;
    gpu::Image m_colour;   ///< one sample
    gpu::Image m_samples;  ///< only when smoothed
    gpu::Image m_depth;
    gpu::Image m_flatDepth;  ///< of one sample; only when smoothed and kept
    gpu::Buffer m_depths;
    bool m_hasDepth = false;
    gpu::Image m_cached;  ///< between uses ready to be copied from
};

}  // namespace render
