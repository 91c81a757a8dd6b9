#pragma once

#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "render/backends/measured_backends.h"
#include "render/backends/overlay_drawer.h"
#include "render/backends/scene_drawer.h"
#include "render/backends/section_drawer.h"
#include "render/frame/render_target.h"

namespace render {

/// Records frames: what both presenters share. Makes pipelines when a format is first drawn.
class Renderer {
public:
    /// Auto goes by what is known of the device now.
    explicit Renderer(gpu::Device& device);

    /// Records the picture of `scene` (may be null) into `target`, whose size and format are set here. Draws the
    /// overlay alone where the settings say that the board is the same. Returns the back end that draws, or drew, the
    /// board. Where smoothing has no room, it goes without; throws gpu::OutOfMemory if that is not enough.
    Backend record(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene* scene,
                   const Camera& camera, const ViewSettings& settings);

    /// Makes the pipelines for boards (Auto: for tilted views), smoothed where the device can or not. Takes longer than
    /// a frame. On any thread, while nothing else is done with this. Throws gpu::OutOfMemory; then `record` tries
    /// again.
    void makeReady(VkFormat colour, Backend backend, bool isSmoothed);
    /// Makes the images and pipelines that `record` would make first; empty where they are there. Pipelines take longer
    /// than a frame, and software devices make no image while they do anything else. To be called as makeReady; nor may
    /// `target` be used meanwhile.
    [[nodiscard]] std::function<void()> preparation(RenderTarget& target, VkExtent2D extent, VkFormat colour,
                                                    BoardScene& scene, const Camera& camera,
                                                    const ViewSettings& settings);
    /// Did `record` find the board cached?
    [[nodiscard]] bool drewOverlayAlone() const { return m_isOverlayAlone; }

private:
    SceneDrawer& sceneDrawer(const TargetFormat& format, Backend backend);
    const SectionDrawer& sectionDrawer(const TargetFormat& format);
    const OverlayDrawer& overlayDrawer(VkFormat colour);
    [[nodiscard]] Backend resolve(const ViewSettings& settings, const FramePlan& plan);
    [[nodiscard]] bool isToBeSmoothed(VkExtent2D extent, Backend backend, const ViewSettings& settings) const;
    /// Smoothed if it is to be, where there is room.
    TargetFormat makeTarget(RenderTarget& target, VkExtent2D extent, VkFormat colour, bool isSmoothed);
    Backend recordBoard(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene& scene,
                        const Camera& camera, const ViewSettings& settings);
    void cacheBoard(gpu::Frame& frame, RenderTarget& target);
    void keepDepth(gpu::Frame& frame, RenderTarget& target);
    void drawOverlays(gpu::Frame& frame, RenderTarget& target, const Camera& camera, const ViewSettings& settings);

    gpu::Device* m_device;
    MeasuredBackends m_measured;
    std::map<std::pair<TargetFormat, Backend>, std::unique_ptr<SceneDrawer>> m_scenes;
    std::map<VkFormat, OverlayDrawer> m_overlays;
    std::map<TargetFormat, SectionDrawer> m_sections;
    Backend m_last = Backend::Auto;  ///< drew the board last
    bool m_isOverlayAlone = false;
    bool m_hasWarned = false;
    bool m_isShortOfDepth = false;   ///< there was no room to keep it: pictures in planes lie over everything
    bool m_isShortOfMemory = false;  ///< there was no room for a smoothed target
};

}  // namespace render
