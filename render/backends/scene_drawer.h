#pragma once

#include "render/backends/let_backend.h"
#include "render/scene/view_settings.h"

namespace render {

/// Draws the batches of a scene: one of the two pipelines.
class SceneDrawer {
public:
    virtual ~SceneDrawer() = default;
    /// As those of LetBackend.
    [[nodiscard]] virtual bool isReadyFor([[maybe_unused]] bool isFlat) const { return true; }
    virtual void makeReadyFor([[maybe_unused]] bool isFlat) {}
    /// Work before drawing begins, for copies whose draw lists lie side by side.
    virtual void cull(std::span<const Recording> group) = 0;
    virtual void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) = 0;
    /// After the opaque batches of all copies that were culled together.
    virtual void finishOpaque(std::span<const Recording>) {}
};

/// Lets by one of their back ends (not Auto), areas by AreaDrawer.
[[nodiscard]] std::unique_ptr<SceneDrawer> makeHybridDrawer(gpu::Device& device, const TargetFormat& target,
                                                            Backend lets);

/// One draw per part, neither culled nor simplified.
[[nodiscard]] std::unique_ptr<SceneDrawer> makeStandardDrawer(gpu::Device& device, const TargetFormat& target);

}  // namespace render
