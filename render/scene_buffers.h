#pragma once

#include <optional>

#include "render/frame_plan.h"
#include "render/gpu/frame_ring.h"
#include "render/view.h"

namespace render {

/// The board on the GPU: one buffer per column, made once.
struct GeometryBuffers {
    gpu::Buffer lets;
    gpu::Buffer clusters;
    gpu::Buffer vertices;
    gpu::Buffer next;
    gpu::Buffer indices;
    gpu::Buffer instances;
    gpu::Buffer drawOfInstance;
    gpu::Buffer bounds;
    gpu::Buffer highlight;
    gpu::Buffer capDraws;  ///< commands without instances: what each frame starts from
    gpu::Buffer wallDraws;
    gpu::Buffer letIndices;
};

/// Rewritten by every frame. One set serves all views: they draw one after the other on one queue.
struct TransientBuffers {
    gpu::Buffer visibleClusters;
    gpu::Buffer visibleLets;
    gpu::Buffer letDraws;
    gpu::Buffer visibleInstances;
    gpu::Buffer capDraws;
    gpu::Buffer wallDraws;
};

/// The board in the standard pipeline: buffers by part.
struct StandardBuffers {
    std::vector<gpu::Buffer> vertices;
    std::vector<gpu::Buffer> indices;
    std::vector<std::uint32_t> indexCounts;
    std::vector<LayerRun> partsOfLayer;
    gpu::Buffer records;  ///< shader::StandardPartRecord

    [[nodiscard]] std::uint64_t bytes() const;
};

struct BoardScene::Impl {
    gpu::Device* device = nullptr;
    gpu::FrameRing uploads;  ///< for small changes; its memory stays small
    SceneLayers layers;
    LetTables letTables;
    std::uint32_t clusterCount = 0;
    std::uint32_t instanceCount = 0;
    std::uint32_t areaDrawCount = 0;
    std::uint32_t elementWords = 0;  ///< of the highlight buffer
    GeometryBuffers geometry;
    TransientBuffers transient;
    std::optional<StandardBuffers> standard;  ///< then there is nothing but this and the highlight

    Impl(gpu::Device& owner, const BoardModel& model);
    Impl(gpu::Device& owner, const StandardModel& model);
    /// Fills in where the shaders of a frame find this scene.
    void setAddresses(shader::FrameData& data) const;
};

}  // namespace render
