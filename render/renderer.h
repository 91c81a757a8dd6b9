#pragma once

#include <memory>
#include <vector>

#include "render/cut_drawer.h"
#include "render/overlay_drawer.h"
#include "render/render_target.h"

namespace render {

/// Records frames: what both presenters share. Makes pipelines when a format is first drawn.
class Renderer {
public:
    explicit Renderer(gpu::Device& device);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Records the picture of `scene` (may be null) into `target`, whose size and format are set here.
    /// Returns the back end that draws. Where smoothing has no room, it goes without; throws gpu::OutOfMemory if that
    /// is not enough.
    Backend record(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene* scene,
                   const Camera& camera, const ViewSettings& settings);

    struct Drawers;

private:
    Drawers& drawersFor(const TargetFormat& format, Backend backend);
    [[nodiscard]] Backend resolve(Backend wanted, const FramePlan& plan);
    template <class Drawer>
    const Drawer& drawerFor(std::vector<std::unique_ptr<Drawer>>& drawers, const TargetFormat& format);
    /// Smoothed if asked for, where there is room.
    TargetFormat makeTarget(RenderTarget& target, VkExtent2D extent, VkFormat colour, Backend backend,
                            const ViewSettings& settings);
    void recordEmpty(gpu::Frame& frame, RenderTarget& target, const ViewSettings& settings);
    void drawOverlay(gpu::Frame& frame, const TargetFormat& format, const Overlay& overlay);

    gpu::Device* m_device;
    std::vector<std::unique_ptr<Drawers>> m_drawers;
    std::vector<std::unique_ptr<OverlayDrawer>> m_overlays;
    std::vector<std::unique_ptr<CutDrawer>> m_cuts;
    bool m_hasWarned = false;
    bool m_isShortOfMemory = false;  ///< there was no room for a smoothed target
};

}  // namespace render
