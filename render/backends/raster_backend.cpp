#include <vector>

#include "render/backends/pull_backend.h"
#include "render/gpu/barrier.h"
#include "render/gpu/device_select.h"
#include "shaders/shared/raster.h"
#include "shaders/spirv.h"

namespace render {
namespace {

class RasterBackend : public PullBackend {
public:
    RasterBackend(gpu::Device& device, const TargetFormat& target)
        : PullBackend(device, target),
          m_device(&device),
          m_rasterise(device, {"rasterise lets", shader::spirv::kRasterLetsComp, sizeof(shader::RasterPush)}),
          m_shade(device, {"shade raster", shader::spirv::kRasterShadeComp, sizeof(shader::RasterPush)}),
          m_resolve(makeResolve(device, target)) {
        ASSERT(device.caps().hasAtomic64 && target.samples == VK_SAMPLE_COUNT_1_BIT);
    }

    void cull(std::span<const Recording> recordings) override {
        PullBackend::cull(recordings);
        recordings.front().frame.beginStage("rasterise");
        clear(recordings.front());
        m_copies = putCopies(recordings);
        m_rasterise.bind(recordings.front().commands());
        std::uint32_t copy = 0;
        for (const Recording& recording : recordings) {
            if (recording.step.letCount > 0) {
                m_copies.copy = copy++;
                m_rasterise.push(recording.commands(), m_copies);
                vkCmdDispatchIndirect(recording.commands(), recording.lists.visibleClusters.buffer,
                                      recording.lists.visibleClusters.offset);
            }
        }
        shade(recordings.front());
    }

    void finishOpaque(std::span<const Recording> recordings) override {
        if (m_copies.copyCount > 0) {
            VkCommandBuffer commands = recordings.front().commands();
            m_resolve.bind(commands);
            m_resolve.push(commands, m_copies);
            vkCmdDraw(commands, 3, 1, 0, 0);
        }
    }

private:
    static gpu::Pipeline makeResolve(gpu::Device& device, const TargetFormat& target) {
        const auto stages = gpu::drawStages(shader::spirv::kOverlayVert, shader::spirv::kRasterResolveFrag);
        return {device, gpu::GraphicsPipelineOptions{"resolve raster", stages, sizeof(shader::RasterPush),
                                                     gpu::Pass::Opaque, false, gpu::Cover::Fragments, target.colour,
                                                     gpu::kDepthFormat, target.samples}};
    }

    /// Small lets make no triangles.
    [[nodiscard]] IndexRun runOf(const Recording& recording, std::uint32_t draw) const override {
        return draw == shader::kBucketRaster ? IndexRun{} : PullBackend::runOf(recording, draw);
    }

    /// Whoever read the pixels before is done (SceneDrawer's barrier before culling).
    void clear(const Recording& recording) {
        const std::uint64_t bytes = rasterBytes(recording.plan);
        if (m_pixels.size() < bytes) {
            m_pixels = gpu::Buffer(*m_device, {"raster", bytes, gpu::MemoryUse::Targets});
        }
        vkCmdFillBuffer(recording.commands(), m_pixels.handle(), 0, bytes, 0);
        gpu::memoryBarrier(recording.commands(), gpu::kCopyWrite, gpu::kCompute);
    }

    void shade(const Recording& recording) {
        recording.frame.beginStage("shade");
        gpu::memoryBarrier(recording.commands(), gpu::kCompute, gpu::kCompute);
        if (m_copies.copyCount > 0) {
            const shader::FrameData& data = recording.plan.data;
            m_shade.bind(recording.commands());
            m_shade.push(recording.commands(), m_copies);
            vkCmdDispatch(recording.commands(), (data.width + shader::kRasterGroupSize - 1) / shader::kRasterGroupSize,
                          data.height, 1);
        }
    }

    /// Copies without lets are left out, so that every id, and 0 too, names a let that is there.
    [[nodiscard]] shader::RasterPush putCopies(std::span<const Recording> recordings) const {
        std::vector<shader::RasterCopy> copies;
        std::uint32_t firstId = 0;
        for (const Recording& recording : recordings) {
            if (recording.step.letCount > 0) {
                copies.push_back({recording.frameData, firstId, 0});
                firstId += recording.step.letCount;
            }
        }
        const gpu::Frame::Slice slice = recordings.front().frame.put(copies);
        return {m_pixels.address(), slice.address, 0, static_cast<std::uint32_t>(copies.size())};
    }

    gpu::Device* m_device;
    gpu::Pipeline m_rasterise;
    gpu::Pipeline m_shade;
    gpu::Pipeline m_resolve;
    gpu::Buffer m_pixels;           ///< shader::RasterPixels
    shader::RasterPush m_copies{};  ///< those culled last
};

}  // namespace

std::unique_ptr<LetBackend> makeRasterBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<RasterBackend>(device, target);
}

std::uint64_t rasterBytes(const FramePlan& plan) {
    return std::uint64_t{plan.data.width} * plan.data.height * sizeof(std::uint64_t);
}

}  // namespace render
