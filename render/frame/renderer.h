#pragma once

#include <memory>
#include <vector>

#include "render/backends/overlay_drawer.h"
#include "render/backends/section_drawer.h"
#include "render/frame/render_target.h"

namespace render {

/// Records frames: what both presenters share. Makes pipelines when a format is first drawn.
class Renderer {
public:
    explicit Renderer(gpu::Device& device);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Records the picture of `scene` (may be null) into `target`, whose size and format are set here. Draws the
    /// overlay alone where the settings say that the board is the same. Returns the back end that draws, or drew, the
    /// board. Where smoothing has no room, it goes without; throws gpu::OutOfMemory if that is not enough.
    Backend record(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene* scene,
                   const Camera& camera, const ViewSettings& settings);

    /// Did `record` find the board cached?
    [[nodiscard]] bool drewOverlayAlone() const { return m_isOverlayAlone; }

    struct Drawers;

private:
    Drawers& drawersFor(const TargetFormat& format, Backend backend);
    [[nodiscard]] Backend resolve(Backend wanted, const FramePlan& plan);
    template <class Drawer, class Format>
    const Drawer& drawerFor(std::vector<std::unique_ptr<Drawer>>& drawers, const Format& format);
    /// Smoothed if requested, where there is room.
    TargetFormat makeTarget(RenderTarget& target, VkExtent2D extent, VkFormat colour, Backend backend,
                            const ViewSettings& settings);
    Backend recordBoard(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene& scene,
                        const Camera& camera, const ViewSettings& settings);
    void cacheBoard(gpu::Frame& frame, RenderTarget& target);
    void drawOverlay(gpu::Frame& frame, RenderTarget& target, const Overlay& overlay);

    gpu::Device* m_device;
    std::vector<std::unique_ptr<Drawers>> m_drawers;
    std::vector<std::unique_ptr<OverlayDrawer>> m_overlays;
    std::vector<std::unique_ptr<SectionDrawer>> m_sections;
    Backend m_last = Backend::Auto;  ///< drew the board last
    bool m_isOverlayAlone = false;
    bool m_hasWarned = false;
    bool m_isShortOfMemory = false;  ///< there was no room for a smoothed target
};

}  // namespace render
