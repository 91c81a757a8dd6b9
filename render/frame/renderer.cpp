#include "render/frame/renderer.h"

#include <spdlog/spdlog.h>

#include "render/backends/backend_choice.h"
#include "render/frame/frame_copies.h"
#include "render/frame/highlight_pass.h"
#include "render/gpu/check.h"
#include "render/gpu/device_select.h"

namespace render {
namespace {

/// The stencil holds the last translucent batch that coloured a sample. With more than 255 of them numbers repeat: then
/// it is cleared.
constexpr std::uint32_t kStencilReferences = 255;

/// Lets within a circle of this radius are left to compute shaders, where there is a choice (docs/performance.md, and
/// performance-gpu.md for cards).
float rasterRadiusPx(const gpu::Caps& caps) {
    return caps.isCpu ? 2.0F : 4.0F;
}

/// Is depth kept, for a picture in a plane?
bool isKept(const ViewSettings& settings) {
    return settings.inPlane.pixels.rgba != nullptr;
}

bool isSmoothed(const RenderTarget& target) {
    return target.format().samples != VK_SAMPLE_COUNT_1_BIT;
}

/// A picture being drawn. A single group of copies is looked through once, before drawing begins; several take turns in
/// the draw lists, and drawing pauses whenever another one comes.
class Picture {
public:
    Picture(SceneDrawer& drawer, const std::vector<CopyGroup>& groups, RenderTarget& target, gpu::Frame& frame)
        : m_drawer(drawer), m_groups(groups), m_target(target), m_frame(frame), m_commands(frame.commands()) {}

    void begin(const glm::vec3& ground) {
        if (!m_groups.empty()) {
            m_drawer.cull(m_groups.front());
        }
        m_frame.beginStage("clear");
        m_target.begin(m_commands, ground);
    }

    void drawOpaque() {
        forGroups([&](std::span<const Recording> group) {
            drawBatch(group, 0, gpu::Pass::Opaque);
            m_drawer.finishOpaque(group);
        });
    }

    /// Translucent layers one after the other from the back: first which of its surfaces is in front, then that one's
    /// colour, once per sample. So the picture does not depend on the order of draws inside a layer.
    void drawTranslucent(const LayerPlan& layers) {
        for (std::uint32_t batch = 1; batch < layers.batches.size(); ++batch) {
            const std::uint32_t reference = (batch - 1) % kStencilReferences + 1;
            if (batch > 1 && reference == 1) {
                clear(m_commands, VK_IMAGE_ASPECT_STENCIL_BIT, m_target.extent());
            }
            const glm::vec3& passed = layers.passed[layers.batches[batch].front()];
            forGroups([&](std::span<const Recording> group) {
                drawBatch(group, batch, gpu::Pass::DepthOnly);
                gpu::Pipeline::setFilter(m_commands, reference, {passed.r, passed.g, passed.b, 1.0F});
                drawBatch(group, batch, gpu::Pass::Blend);
            });
        }
    }

private:
    void drawBatch(std::span<const Recording> group, std::uint32_t batch, gpu::Pass pass) const {
        for (const Recording& recording : group) {
            gpu::Pipeline::setFrontFace(m_commands, recording.isMirrored);
            m_drawer.draw(recording, batch, pass);
        }
    }

    template <class Draw>
    void forGroups(const Draw& draw) {
        for (std::size_t group = 0; group < m_groups.size(); ++group) {
            if (group != m_listed) {
                m_target.pause(m_commands);
                m_drawer.cull(m_groups[group]);
                m_target.resume(m_commands);
                m_listed = group;
            }
            draw(m_groups[group]);
        }
    }

    SceneDrawer& m_drawer;
    const std::vector<CopyGroup>& m_groups;
    RenderTarget& m_target;
    gpu::Frame& m_frame;
    VkCommandBuffer m_commands;
    std::size_t m_listed = 0;  ///< the group whose draw lists are there
};

}  // namespace

Renderer::Renderer(gpu::Device& device) : m_device(&device), m_measured(measuredBackends(device.caps())) {}

Backend Renderer::resolve(const ViewSettings& settings, const FramePlan& plan) {
    const Backend wanted = settings.backend;
    const bool isSmoothed = settings.isSmoothed && !settings.isMono && m_device->caps().canSmooth;
    const BackendChoice choice = chooseBackend(wanted, m_device->caps(), plan, isSmoothed, m_measured);
    if (choice.needs != nullptr && !m_hasWarned) {
        spdlog::warn("The {} back end {}: drawing with {} instead.", nameOf(wanted), choice.needs,
                     nameOf(choice.backend));
        m_hasWarned = true;
    }
    return choice.backend;
}

SceneDrawer& Renderer::sceneDrawer(const TargetFormat& format, Backend backend) {
    std::unique_ptr<SceneDrawer>& drawer = m_scenes[{format, backend}];
    if (drawer == nullptr) {
        drawer = backend == Backend::Standard ? makeStandardDrawer(*m_device, format)
                                              : makeHybridDrawer(*m_device, format, backend);
    }
    return *drawer;
}

void Renderer::makeReady(VkFormat colour, Backend backend, bool isSmoothed) {
    const bool hasSamples = isSmoothed && m_device->caps().canSmooth;
    const Backend fastest = m_measured.of(hasSamples) == Backend::Auto ? Backend::Pull : m_measured.of(hasSamples);
    sceneDrawer({colour, hasSamples ? VK_SAMPLE_COUNT_4_BIT : VK_SAMPLE_COUNT_1_BIT},
                backend == Backend::Auto ? fastest : backend);
}

const SectionDrawer& Renderer::sectionDrawer(const TargetFormat& format) {
    return m_sections.try_emplace(format, *m_device, format).first->second;
}

const OverlayDrawer& Renderer::overlayDrawer(VkFormat colour) {
    return m_overlays.try_emplace(colour, *m_device, colour).first->second;
}

std::function<void()> Renderer::preparation(RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene& scene,
                                            const Camera& camera, const ViewSettings& settings) {
    const FramePlan plan = planFrame(scene.impl().layers, camera, settings, extent.width, extent.height);
    const bool isStandard = scene.impl().steps.front().standard.has_value();
    const Backend backend = isStandard ? Backend::Standard : resolve(settings, plan);
    const bool isSmoothed = isToBeSmoothed(extent, backend, settings);
    const bool hasOverlay = isKept(settings) || settings.overlay.rgba != nullptr;
    const TargetFormat format{colour, isSmoothed ? VK_SAMPLE_COUNT_4_BIT : VK_SAMPLE_COUNT_1_BIT};
    const TargetFormat ofBoard{colour, format.samples, plan.hasSection};
    const bool isFlat = isFlatView(plan);
    const auto made = m_scenes.find({ofBoard, backend});
    const bool isDrawerReady = made != m_scenes.end() && made->second != nullptr && made->second->isReadyFor(isFlat);
    if (target.is(extent, format) && isDrawerReady && (!plan.hasSection || m_sections.contains(format)) &&
        (!hasOverlay || m_overlays.contains(colour))) {
        return {};
    }
    return [this, &target, extent, backend, isSmoothed, isFlat, hasOverlay, ofBoard] {
        const TargetFormat got = makeTarget(target, extent, ofBoard.colour, isSmoothed);
        sceneDrawer({got.colour, got.samples, ofBoard.hasSection}, backend).makeReadyFor(isFlat);
        if (ofBoard.hasSection) {
            sectionDrawer(got);
        }
        if (hasOverlay) {
            overlayDrawer(got.colour);
        }
    };
}

void Renderer::cacheBoard(gpu::Frame& frame, RenderTarget& target) {
    try {
        target.cacheBoard(frame.commands());
    } catch (const gpu::OutOfMemory& shortage) {
        spdlog::debug("{} has no memory for {}: overlays need the board drawn again.", m_device->caps().name,
                      shortage.what);
    }
}

void Renderer::keepDepth(gpu::Frame& frame, RenderTarget& target) {
    try {
        target.keepDepth(frame.commands());
    } catch (const gpu::OutOfMemory& shortage) {
        spdlog::warn("{} has no memory for {}: maps shine through what lies above them.", m_device->caps().name,
                     shortage.what);
        m_isShortOfDepth = true;
    }
}

void Renderer::drawOverlays(gpu::Frame& frame, RenderTarget& target, const Camera& camera,
                            const ViewSettings& settings) {
    const VkExtent2D extent = target.extent();
    const Overlay& laid = settings.inPlane.pixels;
    const bool isLaid = isKept(settings) && laid.width == extent.width && laid.height == extent.height;
    const auto plane = isLaid && target.hasDepth()
                           ? depthOfPlane(camera, settings.inPlane.z, extent.width, extent.height, isSmoothed(target))
                           : std::nullopt;
    const bool isOverAll = isLaid && m_isShortOfDepth && !target.hasDepth();
    if (!plane && !isOverAll && settings.overlay.rgba == nullptr) {
        return;
    }
    const OverlayDrawer& drawer = overlayDrawer(target.format().colour);
    target.beginOver(frame.commands());
    if (plane) {
        drawer.drawInPlane(frame, laid, *plane, target.depths());
    } else if (isOverAll) {
        drawer.draw(frame, laid);
    }
    if (settings.overlay.rgba != nullptr) {
        drawer.draw(frame, settings.overlay);
    }
    target.end(frame.commands());
}

bool Renderer::isToBeSmoothed(VkExtent2D extent, Backend backend, const ViewSettings& settings) const {
    const gpu::Caps& caps = m_device->caps();
    return settings.isSmoothed && !settings.isMono && backend != Backend::Raster && caps.canSmooth &&
           !m_isShortOfMemory && fitsOn(caps, extent, VK_SAMPLE_COUNT_4_BIT);
}

TargetFormat Renderer::makeTarget(RenderTarget& target, VkExtent2D extent, VkFormat colour, bool isSmoothed) {
    const TargetFormat plain{colour, VK_SAMPLE_COUNT_1_BIT};
    const TargetFormat smooth{colour, VK_SAMPLE_COUNT_4_BIT};
    if (isSmoothed) {
        try {
            target.setSize(extent, smooth);
            return smooth;
        } catch (const gpu::OutOfMemory& shortage) {
            spdlog::warn("{} has no memory for {}: drawing without smoothing from now on.", m_device->caps().name,
                         shortage.what);
            m_isShortOfMemory = true;
        }
    }
    target.setSize(extent, plain);
    return plain;
}

Backend Renderer::record(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour, BoardScene* scene,
                         const Camera& camera, const ViewSettings& settings) {
    m_isOverlayAlone = settings.isBoardCached && target.hasCached(extent, colour) &&
                       (scene == nullptr || !isKept(settings) || target.hasDepth() || m_isShortOfDepth);
    if (m_isOverlayAlone) {
        frame.leaveUntimed();
        target.restore(frame.commands());
    } else if (scene != nullptr) {
        m_last = recordBoard(frame, target, extent, colour, *scene, camera, settings);
        if (settings.cachesBoard) {
            cacheBoard(frame, target);
        }
    } else {
        makeTarget(target, extent, colour, isToBeSmoothed(extent, settings.backend, settings));
        target.begin(frame.commands(), backgroundOf(settings));
        target.end(frame.commands());
        m_last = settings.backend;
    }
    drawOverlays(frame, target, camera, settings);
    return m_last;
}

Backend Renderer::recordBoard(gpu::Frame& frame, RenderTarget& target, VkExtent2D extent, VkFormat colour,
                              BoardScene& scene, const Camera& camera, const ViewSettings& settings) {
    scene.impl().sendStates(frame);
    FramePlan plan = planFrame(scene.impl().layers, camera, settings, extent.width, extent.height);
    const bool isStandard = scene.impl().steps.front().standard.has_value();
    const Backend backend = isStandard ? Backend::Standard : resolve(settings, plan);
    const TargetFormat format = makeTarget(target, extent, colour, isToBeSmoothed(extent, backend, settings));
    const std::uint32_t flags = (backend == Backend::Impostor ? shader::kFrameImpostors : 0) |
                                (format.samples != VK_SAMPLE_COUNT_1_BIT ? shader::kFrameSmoothed : 0);
    plan.data.flags |= flags;
    plan.data.rasterRadiusPx = backend == Backend::Raster ? rasterRadiusPx(m_device->caps()) : 0.0F;
    const std::vector<CopyGroup> groups = copiesInView(frame, plan, scene.impl());
    SceneDrawer& drawer = sceneDrawer({format.colour, format.samples, plan.hasSection}, backend);
    Picture picture(drawer, groups, target, frame);
    picture.begin(plan.data.background);
    picture.drawOpaque();
    if (plan.hasSection) {
        sectionDrawer(format).draw(frame, plan, scene.impl().layers, *settings.section);
    }
    if (isKept(settings)) {
        keepDepth(frame, target);
    }
    picture.drawTranslucent(plan.upright);
    if (countStandingOut(scene.impl()) > 0 && !settings.isMono) {
        FramePlan over =
            planFrame(scene.impl().layers, camera, settings, extent.width, extent.height, Subject::StandingOut);
        over.data.flags |= flags;
        drawStandingOut(frame, target, drawer, over, scene.impl(), settings.levels);
    }
    frame.beginStage("end of the board");
    target.end(frame.commands());
    return backend;
}

}  // namespace render
