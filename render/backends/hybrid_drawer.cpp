#include "render/backends/area_drawer.h"
#include "render/backends/scene_drawer.h"
#include "render/gpu/barrier.h"

namespace render {
namespace {

std::unique_ptr<LetBackend> makeLetBackend(gpu::Device& device, const TargetFormat& target, Backend which) {
    switch (which) {
        case Backend::Mesh: return makeMeshBackend(device, target);
        case Backend::Impostor: return makeImpostorBackend(device, target);
        case Backend::Raster: return makeRasterBackend(device, target);
        default: return makePullBackend(device, target);
    }
}

class HybridDrawer : public SceneDrawer {
public:
    HybridDrawer(gpu::Device& device, const TargetFormat& target, Backend lets)
        : m_areas(device, target), m_lets(makeLetBackend(device, target, lets)) {}

    [[nodiscard]] bool isReadyFor(bool isFlat) const override { return m_lets->isReadyFor(isFlat); }
    void makeReadyFor(bool isFlat) override { m_lets->makeReadyFor(isFlat); }

    void cull(std::span<const Recording> group) override {
        VkCommandBuffer commands = group.front().commands();
        group.front().frame.beginStage("cull areas");
        // Draw lists are shared by all groups and frames: the one before must be done with them.
        gpu::memoryBarrier(commands, gpu::kAnything, gpu::kCopyWrite);
        for (const Recording& recording : group) {
            m_areas.reset(recording);
            m_lets->reset(recording);
        }
        gpu::memoryBarrier(commands, gpu::kCopyWrite, gpu::kCompute);
        for (const Recording& recording : group) {
            m_areas.cull(recording);
        }
        m_lets->cull(group);
        group.front().frame.beginStage("line up areas");
        gpu::memoryBarrier(commands, gpu::kCompute, gpu::kCompute);
        for (const Recording& recording : group) {
            m_areas.lineUp(recording);
        }
        gpu::memoryBarrier(commands, gpu::kCompute, gpu::kAnyRead);
    }

    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) override {
        recording.frame.beginStage("areas");
        m_areas.draw(recording, batch, pass);
        recording.frame.beginStage("lets");
        m_lets->draw(recording, batch, pass);
    }

    void finishOpaque(std::span<const Recording> group) override {
        group.front().frame.beginStage("resolve");
        m_lets->finishOpaque(group);
    }

private:
    AreaDrawer m_areas;
    std::unique_ptr<LetBackend> m_lets;
};

}  // namespace

std::unique_ptr<SceneDrawer> makeHybridDrawer(gpu::Device& device, const TargetFormat& target, Backend lets) {
    return std::make_unique<HybridDrawer>(device, target, lets);
}

}  // namespace render
