#pragma once

#include <functional>
#include <optional>

#include "render/backends/let_backend.h"

namespace render {

/// Draws areas: caps from the stored triangles, walls pulled from the outlines, one indirect command per shape and
/// layer; in outline mode the outlines alone. The same for all let back ends.
class AreaDrawer {
public:
    AreaDrawer(gpu::Device& device, const TargetFormat& target);

    void reset(const Recording& recording) const;
    void cull(const Recording& recording) const;
    /// Makes commands of what `cull` has found, in order and without gaps: a device takes its time for each command,
    /// whether it draws something or not.
    void lineUp(const Recording& recording) const;
    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass);

private:
    void drawCaps(const Recording& recording, gpu::Pass pass, std::uint32_t batch, std::uint32_t face) const;
    /// What is too small for more: on the face that is seen.
    void drawPatches(const Recording& recording, gpu::Pass pass, std::uint32_t batch) const;
    /// What is pulled from the outlines: walls, or in flat views lines.
    void drawEdges(const Recording& recording, gpu::Pass pass, std::uint32_t batch, const PassPipelines& pipelines,
                   bool SeenFaces::*side) const;

    gpu::Pipeline m_cull;
    gpu::Pipeline m_lineUp;
    PassPipelines m_caps;
    PassPipelines m_patches;
    PassPipelines m_walls;
    std::function<PassPipelines()> m_makeOutlines;
    std::optional<PassPipelines> m_outlines;  ///< made when they are drawn first
};

}  // namespace render
