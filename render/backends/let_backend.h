#pragma once

#include <array>
#include <compare>
#include <memory>

#include "render/culling/frame_plan.h"
#include "render/gpu/frame_ring.h"
#include "render/gpu/pipeline.h"
#include "render/scene/scene_buffers.h"

namespace render {

/// A pipeline for each way of passing over the scene.
using PassPipelines = std::array<gpu::Pipeline, 3>;
[[nodiscard]] constexpr std::size_t passRow(gpu::Pass pass) {
    return static_cast<std::size_t>(pass);
}

/// What pipelines must fit.
struct TargetFormat {
    VkFormat colour = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    bool hasSection = false;  ///< fragments test on which side of the section plane they are (shaders/lib/section.glsl)
    auto operator<=>(const TargetFormat&) const = default;
};

[[nodiscard]] PassPipelines makePassPipelines(gpu::Device& device, std::string_view label,
                                              std::span<const gpu::ShaderStage> stages, bool cullsBackFaces,
                                              const TargetFormat& target, gpu::Cover cover = gpu::Cover::Triangles);

/// A frame being recorded: one copy of a step on it.
struct Recording {
    gpu::Frame& frame;
    const FramePlan& plan;
    const BoardScene::Impl& scene;
    const LayerPlan& layers;  ///< upright or flipped
    const SceneStep& step;
    DrawLists lists;
    bool isMirrored = false;
    VkDeviceAddress frameData = 0;
    shader::Shadows shadows{};  ///< those of the frame data

    [[nodiscard]] VkCommandBuffer commands() const { return frame.commands(); }
    /// With the push constants that shaders know this copy by.
    void bind(const gpu::Pipeline& pipeline, std::uint32_t first = 0, std::uint32_t face = 0) const {
        pipeline.bind(commands());
        push(pipeline, first, face);
    }
    void push(const gpu::Pipeline& pipeline, std::uint32_t first, std::uint32_t face) const {
        pipeline.push(commands(), shader::Push{frameData, first, face, shadows});
    }
};

/// Workgroups, along x and y, of compute shaders with a thread for each of so many clusters or area instances.
[[nodiscard]] glm::uvec2 cullGroups(std::uint32_t count);
/// Dispatches them, for the pipeline that is bound (shaders/lib/cull_thread.glsl).
void dispatchCull(VkCommandBuffer commands, std::uint32_t count);

/// Draws lets. All ways take the same buffers and describe the same prisms: mesh and pull as polygons (lib/prism.glsl),
/// impostors as true outlines (lib/outline.glsl, lib/sight.glsl).
class LetBackend {
public:
    virtual ~LetBackend() = default;
    /// Are the pipelines there that `draw` takes for flat views (isFlatView), or for others? It makes what it lacks.
    [[nodiscard]] virtual bool isReadyFor([[maybe_unused]] bool isFlat) const { return true; }
    virtual void makeReadyFor([[maybe_unused]] bool isFlat) {}
    /// Copies that must be done before `cull`.
    virtual void reset(const Recording& recording) = 0;
    /// Compute work before drawing begins.
    virtual void cull(std::span<const Recording> recordings) = 0;
    virtual void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) = 0;
    /// After the opaque batches of all copies that were culled together.
    virtual void finishOpaque(std::span<const Recording>) {}
};

/// Task and mesh shaders (the paper's way). Needs Caps::hasMeshShader.
[[nodiscard]] std::unique_ptr<LetBackend> makeMeshBackend(gpu::Device& device, const TargetFormat& target);

/// Compute culling into instanced indirect draws and vertices pulled from the lets; for every device.
[[nodiscard]] std::unique_ptr<LetBackend> makePullBackend(gpu::Device& device, const TargetFormat& target);

/// The pull back end's culling, and for each let a box (in flat views a rectangle) whose fragments are cut to its true
/// outline. Needs Caps::canShadeSamples, but for flat views.
[[nodiscard]] std::unique_ptr<LetBackend> makeImpostorBackend(gpu::Device& device, const TargetFormat& target);

/// Compute shaders find the nearest of all small opaque lets for every pixel, by the same lines of sight as impostors,
/// and a pass over the picture adds them; larger and translucent ones are drawn as pull draws them. Needs
/// Caps::hasAtomic64 and one sample per pixel. Lets at one depth are distinguished by their rows: the picture does not
/// depend on the order of drawing.
[[nodiscard]] std::unique_ptr<LetBackend> makeRasterBackend(gpu::Device& device, const TargetFormat& target);

/// Device memory that the raster back end takes for a picture.
[[nodiscard]] std::uint64_t rasterBytes(const FramePlan& plan);

}  // namespace render
