#include "render/backends/pull_backend.h"

#include "render/gpu/barrier.h"
#include "shaders/spirv.h"

namespace render {

PullBackend::PullBackend(gpu::Device& device)
    : m_cullClusters(device, {"cull clusters", shader::spirv::kCullClustersComp, sizeof(shader::Push)}),
      m_cullLets(device, {"cull lets", shader::spirv::kCullLetsComp, sizeof(shader::Push)}),
      m_lineUpDraws(device, {"line up draws", shader::spirv::kLineUpDrawsComp, sizeof(shader::Push)}),
      m_placeLets(device, {"place lets", shader::spirv::kPlaceLetsComp, sizeof(shader::Push)}) {}

PullBackend::PullBackend(gpu::Device& device, const TargetFormat& target) : PullBackend(device) {
    const auto stages = gpu::drawStages(shader::spirv::kLetPullVert, shader::spirv::kBoardFrag);
    m_pipelines = makePassPipelines(device, "lets (pull)", stages, true, target);
}

IndexRun PullBackend::runOf(const Recording& recording, std::uint32_t draw) const {
    return recording.scene.letTables.run(draw, recording.plan.faces);
}

/// The commands of all batches before culling.
std::vector<shader::DrawIndexed> PullBackend::emptyDraws(const Recording& recording) const {
    std::vector<shader::DrawIndexed> draws;
    for (std::size_t batch = 0; batch < recording.layers.batches.size(); ++batch) {
        for (std::uint32_t draw = 0; draw < shader::kDrawCount; ++draw) {
            const IndexRun run = runOf(recording, draw);
            draws.push_back({run.count, 0, run.first, 0, 0});
        }
    }
    return draws;
}

void PullBackend::reset(const Recording& recording) {
    const gpu::Frame::Slice draws = recording.frame.put(emptyDraws(recording));
    const DrawLists& lists = recording.lists;
    const VkBufferCopy region{draws.offset, lists.letDraws.offset, draws.bytes.size()};
    vkCmdCopyBuffer(recording.commands(), draws.buffer, lists.letDraws.buffer, 1, &region);
    constexpr std::uint32_t kNoClusters[] = {0, 1, 1, 0};  // a dispatch of no workgroups, then the count
    vkCmdUpdateBuffer(recording.commands(), lists.visibleClusters.buffer, lists.visibleClusters.offset,
                      sizeof(kNoClusters), kNoClusters);
}

void PullBackend::cull(std::span<const Recording> recordings) {
    gpu::Frame& frame = recordings.front().frame;
    frame.beginStage("cull clusters");
    for (const Recording& recording : recordings) {
        recording.bind(m_cullClusters);
        dispatchCull(recording.commands(), recording.step.clusterCount);
    }
    frame.beginStage("cull lets");
    dispatchForClusters(m_cullLets, recordings);
    frame.beginStage("line up draws");
    gpu::memoryBarrier(frame.commands(), gpu::kCompute, gpu::kAnyRead);
    for (const Recording& recording : recordings) {
        recording.bind(m_lineUpDraws);
        vkCmdDispatch(recording.commands(), 1, 1, 1);
    }
    frame.beginStage("place lets");
    dispatchForClusters(m_placeLets, recordings);
}

void PullBackend::draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) {
    recording.bind(pipelinesFor(recording.plan)[passRow(pass)]);
    vkCmdBindIndexBuffer(recording.commands(), recording.scene.letIndices.handle(), 0, VK_INDEX_TYPE_UINT32);
    constexpr std::uint32_t kStride = sizeof(shader::DrawIndexed);
    vkCmdDrawIndexedIndirectCount(recording.commands(), recording.lists.letDraws.buffer,
                                  recording.lists.letDraws.offset + std::uint64_t{batch} * shader::kDrawCount * kStride,
                                  recording.step.geometry.countOfAll.handle(), 0, shader::kDrawCount, kStride);
}

void dispatchForClusters(const gpu::Pipeline& pipeline, std::span<const Recording> recordings) {
    gpu::memoryBarrier(recordings.front().commands(), gpu::kCompute, gpu::kAnyRead);
    for (const Recording& recording : recordings) {
        recording.bind(pipeline);
        vkCmdDispatchIndirect(recording.commands(), recording.lists.visibleClusters.buffer,
                              recording.lists.visibleClusters.offset);
    }
}

std::unique_ptr<LetBackend> makePullBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<PullBackend>(device, target);
}

}  // namespace render
