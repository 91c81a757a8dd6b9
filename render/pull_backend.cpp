#include <algorithm>
#include <vector>

#include "render/gpu/barrier.h"
#include "render/let_backend.h"
#include "shaders/spirv.h"

namespace render {
namespace {

/// Lets of a batch by topology.
struct LetCounts {
    std::uint32_t open = 0;
    std::uint32_t tubes = 0;
};

LetCounts letsOf(const SceneStep& step, const LayerBatch& batch) {
    LetCounts counts;
    for (const std::uint32_t layer : batch) {
        counts.open += step.layers[layer].openLets;
        counts.tubes += step.layers[layer].tubes;
    }
    return counts;
}

/// How many lets of a batch a bucket may be asked to hold: all of its topology. Tubes of less than a pixel join the
/// open quads.
std::uint32_t capacityOf(const LetCounts& lets, std::uint32_t topology, std::uint32_t level) {
    if (level == shader::kLevelQuad) {
        return topology == shader::kTopologyOpen ? lets.open + lets.tubes : 0;
    }
    return topology == shader::kTopologyOpen ? lets.open : lets.tubes;
}

/// The commands of all batches before culling; `firstInstance` is where a bucket's lets begin in `visibleLets`.
std::vector<shader::DrawIndexed> emptyDraws(const Recording& recording) {
    std::vector<shader::DrawIndexed> draws;
    std::uint32_t firstInstance = 0;
    for (const LayerBatch& batch : recording.layers.batches) {
        const LetCounts lets = letsOf(recording.step, batch);
        for (std::uint32_t bucket = 0; bucket < shader::kBucketCount; ++bucket) {
            const IndexRun run = recording.scene.letTables.run(bucket, recording.plan.faces);
            draws.push_back({run.count, 0, run.first, 0, firstInstance});
            firstInstance += capacityOf(lets, bucket / shader::kLevelCount, bucket % shader::kLevelCount);
        }
    }
    return draws;
}

class PullBackend : public LetBackend {
public:
    PullBackend(gpu::Device& device, const TargetFormat& target)
        : m_cullClusters(device, {"cull clusters", shader::spirv::kCullClustersComp, sizeof(shader::Push)}),
          m_cullLets(device, {"cull lets", shader::spirv::kCullLetsComp, sizeof(shader::Push)}) {
        const gpu::ShaderStage stages[] = {{VK_SHADER_STAGE_VERTEX_BIT, shader::spirv::kLetPullVert},
                                           {VK_SHADER_STAGE_FRAGMENT_BIT, shader::spirv::kBoardFrag}};
        m_pipelines = makePassPipelines(device, "lets (pull)", stages, true, target);
    }

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
        gpu::memoryBarrier(recordings.front().commands(), gpu::kCompute, gpu::kAnyRead);
        for (const Recording& recording : recordings) {
            m_cullLets.bind(recording.commands());
            m_cullLets.push(recording.commands(), shader::Push{recording.frameData, 0, 0});
            vkCmdDispatchIndirect(recording.commands(), recording.lists.visibleClusters.buffer,
                                  recording.lists.visibleClusters.offset);
        }
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
    gpu::Pipeline m_cullClusters;
    gpu::Pipeline m_cullLets;
    PassPipelines m_pipelines;
};

}  // namespace

std::unique_ptr<LetBackend> makePullBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<PullBackend>(device, target);
}

}  // namespace render
