#include <algorithm>
#include <vector>

#include "render/gpu/barrier.h"
#include "render/let_backend.h"
#include "shaders/spirv.h"

namespace render {
namespace {

/// The commands of all batches before culling.
std::vector<shader::DrawIndexed> emptyDraws(const Recording& recording) {
    std::vector<shader::DrawIndexed> draws;
    for (std::size_t batch = 0; batch < recording.layers.batches.size(); ++batch) {
        for (std::uint32_t bucket = 0; bucket < shader::kBucketCount; ++bucket) {
            const IndexRun run = recording.scene.letTables.run(bucket, recording.plan.faces);
            draws.push_back({run.count, 0, run.first, 0, 0});
        }
    }
    return draws;
}

class PullBackend : public LetBackend {
public:
    PullBackend(gpu::Device& device, PassPipelines pipelines)
        : m_cullClusters(device, {"cull clusters", shader::spirv::kCullClustersComp, sizeof(shader::Push)}),
          m_cullLets(device, {"cull lets", shader::spirv::kCullLetsComp, sizeof(shader::Push)}),
          m_lineUpDraws(device, {"line up draws", shader::spirv::kLineUpDrawsComp, sizeof(shader::Push)}),
          m_placeLets(device, {"place lets", shader::spirv::kPlaceLetsComp, sizeof(shader::Push)}),
          m_pipelines(std::move(pipelines)) {}

    void reset(const Recording& recording) override {
        const gpu::Frame::Slice draws =
            recording.frame.put(std::span<const shader::DrawIndexed>(emptyDraws(recording)));
        const DrawLists& lists = recording.lists;
        const VkBufferCopy region{draws.offset, lists.letDraws.offset, draws.bytes.size()};
        vkCmdCopyBuffer(recording.commands(), draws.buffer, lists.letDraws.buffer, 1, &region);
        constexpr std::uint32_t kNoClusters[] = {0, 1, 1, 0};  // a dispatch of no workgroups, then the count
        vkCmdUpdateBuffer(recording.commands(), lists.visibleClusters.buffer, lists.visibleClusters.offset,
                          sizeof(kNoClusters), kNoClusters);
    }

    void cull(std::span<const Recording> recordings) override {
        for (const Recording& recording : recordings) {
            m_cullClusters.bind(recording.commands());
            m_cullClusters.push(recording.commands(), shader::Push{recording.frameData, 0, 0});
            const std::uint32_t groups =
                (recording.step.clusterCount + shader::kCullGroupSize - 1) / shader::kCullGroupSize;
            vkCmdDispatch(recording.commands(), groups, 1, 1);
        }
        dispatchForClusters(m_cullLets, recordings);
        gpu::memoryBarrier(recordings.front().commands(), gpu::kCompute, gpu::kAnyRead);
        for (const Recording& recording : recordings) {
            m_lineUpDraws.bind(recording.commands());
            m_lineUpDraws.push(recording.commands(), shader::Push{recording.frameData, 0, 0});
            vkCmdDispatch(recording.commands(), 1, 1, 1);
        }
        dispatchForClusters(m_placeLets, recordings);
    }

    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) override {
        const gpu::Pipeline& pipeline = m_pipelines[passRow(pass)];
        pipeline.bind(recording.commands());
        pipeline.push(recording.commands(), shader::Push{recording.frameData, 0, 0});
        vkCmdBindIndexBuffer(recording.commands(), recording.scene.letIndices.handle(), 0, VK_INDEX_TYPE_UINT32);
        constexpr std::uint32_t kStride = sizeof(shader::DrawIndexed);
        vkCmdDrawIndexedIndirect(
            recording.commands(), recording.lists.letDraws.buffer,
            recording.lists.letDraws.offset + std::uint64_t{batch} * shader::kBucketCount * kStride,
            shader::kBucketCount, kStride);
    }

private:
    /// One workgroup for each cluster in view, after all work before.
    static void dispatchForClusters(const gpu::Pipeline& pipeline, std::span<const Recording> recordings) {
        gpu::memoryBarrier(recordings.front().commands(), gpu::kCompute, gpu::kAnyRead);
        for (const Recording& recording : recordings) {
            pipeline.bind(recording.commands());
            pipeline.push(recording.commands(), shader::Push{recording.frameData, 0, 0});
            vkCmdDispatchIndirect(recording.commands(), recording.lists.visibleClusters.buffer,
                                  recording.lists.visibleClusters.offset);
        }
    }

    gpu::Pipeline m_cullClusters;
    gpu::Pipeline m_cullLets;
    gpu::Pipeline m_lineUpDraws;
    gpu::Pipeline m_placeLets;
    PassPipelines m_pipelines;
};

}  // namespace

std::unique_ptr<LetBackend> makePullBackend(gpu::Device& device, const TargetFormat& target) {
    const gpu::ShaderStage stages[] = {{VK_SHADER_STAGE_VERTEX_BIT, shader::spirv::kLetPullVert},
                                       {VK_SHADER_STAGE_FRAGMENT_BIT, shader::spirv::kBoardFrag}};
    return std::make_unique<PullBackend>(device, makePassPipelines(device, "lets (pull)", stages, true, target));
}

std::unique_ptr<LetBackend> makeImpostorBackend(gpu::Device& device, const TargetFormat& target) {
    const gpu::ShaderStage stages[] = {{VK_SHADER_STAGE_VERTEX_BIT, shader::spirv::kLetImpostorVert},
                                       {VK_SHADER_STAGE_FRAGMENT_BIT, shader::spirv::kLetImpostorFrag}};
    return std::make_unique<PullBackend>(device,
                                         makePassPipelines(device, "lets (impostor)", stages, true, target, true));
}

bool canUseImpostors(const FramePlan& plan) {
    const bool isParallel = plan.data.eye.w == 0.0F;
    return isParallel && !plan.faces.walls && plan.faces.upper != plan.faces.lower;
}

}  // namespace render
