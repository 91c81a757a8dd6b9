#include "tri/gpu/device_forest.h"

#include <algorithm>
#include <cstring>

#include "model/base/assert.h"
#include "render/gpu/barrier.h"
#include "shaders/spirv.h"

namespace tri::gpu {

namespace kernel = shader::tri;
namespace spirv = shader::spirv;

using render::gpu::Buffer;
using render::gpu::Pipeline;

namespace {

Pipeline make(render::gpu::Device& device, const char* label, spirv::Code code) {
    return {device, render::gpu::ComputePipelineOptions{label, code, sizeof(kernel::Push)}};
}

/// Every kernel sees what those before it did; the numbers of workgroups are among that.
void finishBefore(VkCommandBuffer commands) {
    const render::gpu::Access access{
        VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
        VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
    render::gpu::memoryBarrier(commands, render::gpu::kCompute, access);
}

}  // namespace

Kernels::Kernels(render::gpu::Device& device)
    : init(make(device, "tri init", spirv::kTriInitComp)),
      small(make(device, "tri small", spirv::kTriSmallComp)),
      advance(make(device, "tri advance", spirv::kTriAdvanceComp)),
      vote(make(device, "tri vote", spirv::kTriVoteComp)),
      claimPlace(make(device, "tri claim place", spirv::kTriClaimPlaceComp)),
      split(make(device, "tri split", spirv::kTriSplitComp)),
      relocateInserted(make(device, "tri relocate inserted", spirv::kTriRelocateInsertedComp)),
      findContours(make(device, "tri find contours", spirv::kTriFindContoursComp)),
      claimCorridor(make(device, "tri claim corridor", spirv::kTriClaimCorridorComp)),
      rebuildCorridor(make(device, "tri rebuild corridor", spirv::kTriRebuildCorridorComp)),
      testEdges(make(device, "tri test edges", spirv::kTriTestEdgesComp)),
      flip(make(device, "tri flip", spirv::kTriFlipComp)),
      relocateFlipped(make(device, "tri relocate flipped", spirv::kTriRelocateFlippedComp)),
      fixLinks(make(device, "tri fix links", spirv::kTriFixLinksComp)),
      decide(make(device, "tri decide", spirv::kTriDecideComp)),
      prove(make(device, "tri prove", spirv::kTriProveComp)),
      countKept(make(device, "tri count kept", spirv::kTriCountKeptComp)),
      sumKept(make(device, "tri sum kept", spirv::kTriSumKeptComp)),
      writeKept(make(device, "tri write kept", spirv::kTriWriteKeptComp)) {}

DeviceForest::DeviceForest(render::gpu::Device& device, render::gpu::FrameRing& ring, const ForestData& data)
    : m_device(&device), m_ring(&ring), m_record(recordOf(data)) {
    for (const Column& column : columnsOf(data)) {
        m_offsets.push_back(column.offset);
        const Buffer& buffer = m_columns.emplace_back(
            device, render::gpu::BufferOptions{column.label, column.bytes, render::gpu::MemoryUse::Transient});
        const VkDeviceAddress address = buffer.address();
        std::memcpy(reinterpret_cast<std::byte*>(&m_record) + column.offset, &address, sizeof(address));
        if (column.initial != nullptr &&
            !render::gpu::upload(ring, buffer, {static_cast<const std::byte*>(column.initial), column.bytes})) {
            return;
        }
    }
    m_forest = Buffer(device, {"tri forest", sizeof(m_record), render::gpu::MemoryUse::Transient});
    static_cast<void>(render::gpu::upload(ring, m_forest, std::as_bytes(std::span(&m_record, 1))));
}

const Buffer& DeviceForest::column(std::size_t offset) const {
    const auto found = std::ranges::find(m_offsets, offset);
    ASSERT(found != m_offsets.end());
    return m_columns[static_cast<std::size_t>(found - m_offsets.begin())];
}

void DeviceForest::dispatch(VkCommandBuffer commands, const Pipeline& pipeline, std::uint32_t groups) const {
    pipeline.bind(commands);
    pipeline.push(commands, kernel::Push{{m_forest.address()}, 0, 0});
    // Workgroups in rows, as advance.h lays them out.
    constexpr std::uint32_t kRow = kernel::kMaxGroupsX;
    vkCmdDispatch(commands, std::min(groups, kRow), (groups + kRow - 1) / kRow, 1);
    finishBefore(commands);
}

/// As many workgroups as the device wrote to the member of Control that lies `groups` bytes into it.
void DeviceForest::run(VkCommandBuffer commands, const Pipeline& kernel, std::size_t groups,
                       std::uint32_t stage) const {
    kernel.bind(commands);
    kernel.push(commands, kernel::Push{{m_forest.address()}, stage, 0});
    vkCmdDispatchIndirect(commands, column(offsetof(kernel::Forest, control)).handle(), groups);
    finishBefore(commands);
}

void DeviceForest::recordInit(VkCommandBuffer commands, const Kernels& kernels) const {
    const Buffer& found = column(offsetof(kernel::Forest, found));
    vkCmdFillBuffer(commands, found.handle(), 0, VK_WHOLE_SIZE, 0);
    render::gpu::memoryBarrier(commands, render::gpu::kCopyWrite, render::gpu::kCompute);
    dispatch(commands, kernels.init, (m_record.vertexCount + kernel::kGroupSize - 1) / kernel::kGroupSize);
}

void DeviceForest::recordSmall(VkCommandBuffer commands, const Kernels& kernels) const {
    if (m_record.smallTrees > 0) {
        dispatch(commands, kernels.small, m_record.smallTrees);
    }
}

void DeviceForest::recordStep(VkCommandBuffer commands, const Kernels& kernels) const {
    using kernel::Control;
    dispatch(commands, kernels.advance, 1);
    run(commands, kernels.vote, offsetof(Control, insertGroups));
    run(commands, kernels.claimPlace, offsetof(Control, insertGroups));
    run(commands, kernels.split, offsetof(Control, insertGroups));
    run(commands, kernels.fixLinks, offsetof(Control, splitGroups), kernel::kStageInsert);
    run(commands, kernels.relocateInserted, offsetof(Control, insertGroups));
    run(commands, kernels.findContours, offsetof(Control, contourGroups));
    run(commands, kernels.claimCorridor, offsetof(Control, edgeGroups));
    run(commands, kernels.rebuildCorridor, offsetof(Control, edgeGroups));
    run(commands, kernels.fixLinks, offsetof(Control, contourGroups), kernel::kStageRebuild);
    run(commands, kernels.testEdges, offsetof(Control, flipGroups));
    run(commands, kernels.flip, offsetof(Control, flipGroups));
    run(commands, kernels.fixLinks, offsetof(Control, flipGroups), kernel::kStageFlip);
    run(commands, kernels.relocateFlipped, offsetof(Control, relocateGroups));
}

void DeviceForest::recordErase(VkCommandBuffer commands, const Kernels& kernels) const {
    const std::uint32_t slots = 2 * m_record.vertexCount;
    const std::uint32_t groups = (slots + kernel::kGroupSize - 1) / kernel::kGroupSize;
    const std::uint32_t blocks = (slots + kernel::kBlockSize - 1) / kernel::kBlockSize;
    dispatch(commands, kernels.decide, groups);
    dispatch(commands, kernels.prove, groups);
    dispatch(commands, kernels.countKept, blocks);
    dispatch(commands, kernels.sumKept, 1);
    dispatch(commands, kernels.writeKept, blocks);
}

kernel::Control DeviceForest::control() const {
    const auto controls = read<kernel::Control>(offsetof(kernel::Forest, control), 1);
    return controls.empty() ? kernel::Control{} : controls.front();
}

}  // namespace tri::gpu
