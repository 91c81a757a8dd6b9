#pragma once

#include <array>
#include <span>

#include "render/gpu/pipeline_store.h"

namespace render::gpu {

/// Code of a shader, which stays where it is as long as devices that use it.
using Spirv = std::span<const std::uint32_t>;

struct ComputePipelineOptions {
    std::string_view label;
    Spirv shader;
    std::uint32_t pushBytes = 0;
};

struct ShaderStage {
    VkShaderStageFlagBits stage = VK_SHADER_STAGE_VERTEX_BIT;
    Spirv shader;
};

/// A vertex and a fragment stage.
[[nodiscard]] inline std::array<ShaderStage, 2> drawStages(Spirv vertexShader, Spirv fragmentShader) {
    return {ShaderStage{VK_SHADER_STAGE_VERTEX_BIT, vertexShader},
            ShaderStage{VK_SHADER_STAGE_FRAGMENT_BIT, fragmentShader}};
}

/// How a pipeline treats what is already there. Depth is reversed: nearer is greater.
enum class Pass : std::uint8_t {
    Opaque,     ///< nearer wins, depth and colour written
    DepthOnly,  ///< nearer wins, depth written
    Blend,      ///< exactly at the depth written before, colour blended, at most once per sample and stencil reference
    Overlay,    ///< over everything, colour blended
    InFront     ///< over everything, depth and colour written
};

/// Who says what a triangle covers.
enum class Cover : std::uint8_t {
    Triangles,  ///< the rasteriser
    Fragments,  ///< the fragment stage too, with discard or a sample mask
    Samples     ///< likewise, run for every sample by itself (Caps::canShadeSamples)
};

struct GraphicsPipelineOptions {
    std::string_view label;
    std::span<const ShaderStage> stages;  ///< of Cover::Triangles the fragment stage is left out for DepthOnly
    std::uint32_t pushBytes = 0;
    Pass pass = Pass::Opaque;
    bool cullsBackFaces = false;  ///< which side is the front is dynamic
    Cover cover = Cover::Triangles;
    VkFormat colourFormat = VK_FORMAT_UNDEFINED;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    bool hasSection = false;  ///< kCuts of lib/section.glsl; the fragment stage then says what is covered
};

/// A compute or graphics pipeline. Its only interface to data are push constants (buffers go by address). Viewport,
/// scissor, front face, stencil reference and blend constants are dynamic. The device makes and keeps one of each kind
/// (pipeline_store.h): this refers to it, and does not outlive the device.
class Pipeline {
public:
    Pipeline() = default;
    Pipeline(Device& device, const ComputePipelineOptions& options);
    Pipeline(Device& device, const GraphicsPipelineOptions& options);

    void bind(VkCommandBuffer commands) const;
    /// Sets the push constants for what follows; all pipelines take the same ones.
    template <class T>
    void push(VkCommandBuffer commands, const T& value) const {
        pushBytes(commands, &value, sizeof(T));
    }
    /// Counter-clockwise faces are the front ones, in mirrored copies clockwise ones. Holds for all pipelines.
    static void setFrontFace(VkCommandBuffer commands, bool isMirrored) {
        vkCmdSetFrontFace(commands, isMirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    }
    /// How much of each colour passes through what Pass::Blend draws, and through which stencil reference it is marked.
    /// To be set for every layer, after its depth was drawn.
    static void setFilter(VkCommandBuffer commands, std::uint32_t reference, const float (&passed)[4]) {
        vkCmdSetStencilReference(commands, VK_STENCIL_FACE_FRONT_AND_BACK, reference);
        vkCmdSetBlendConstants(commands, passed);
    }
    explicit operator bool() const { return m_made != nullptr; }

private:
    void pushBytes(VkCommandBuffer commands, const void* data, std::uint32_t size) const;

    const MadePipeline* m_made = nullptr;
};

}  // namespace render::gpu
