#include "tri/gpu/device_forest.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "model/base/assert.h"
#include "render/gpu/barrier.h"
#include "shaders/spirv.h"

namespace tri::gpu {

namespace kernel = shader::tri;
namespace spirv = shader::spirv;

using render::gpu::Buffer;
using render::gpu::Frame;

namespace {

Kernel make(render::gpu::Device& device, const char* name, spirv::Code code) {
    const std::string label = std::string("tri ") + name;
    return {name, {device, render::gpu::ComputePipelineOptions{label, code, sizeof(kernel::Push)}}};
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
    : init(make(device, "init", spirv::kTriInitComp)),
      tiny(make(device, "tiny", spirv::kTriTinyComp)),
      small(make(device, "small", spirv::kTriSmallComp)),
      advance(make(device, "advance", spirv::kTriAdvanceComp)),
      vote(make(device, "vote", spirv::kTriVoteComp)),
      claimPlace(make(device, "claim place", spirv::kTriClaimPlaceComp)),
      split(make(device, "split", spirv::kTriSplitComp)),
      relocateInserted(make(device, "relocate inserted", spirv::kTriRelocateInsertedComp)),
      findContours(make(device, "find contours", spirv::kTriFindContoursComp)),
      claimCorridor(make(device, "claim corridor", spirv::kTriClaimCorridorComp)),
      rebuildCorridor(make(device, "rebuild corridor", spirv::kTriRebuildCorridorComp)),
      testEdges(make(device, "test edges", spirv::kTriTestEdgesComp)),
      flip(make(device, "flip", spirv::kTriFlipComp)),
      fixFlips(make(device, "fix flips", spirv::kTriFixFlipsComp)),
      relocateFlipped(make(device, "relocate flipped", spirv::kTriRelocateFlippedComp)),
      tail(make(device, "tail", spirv::kTriTailComp)),
      fixLinks(make(device, "fix links", spirv::kTriFixLinksComp)),
      decide(make(device, "decide", spirv::kTriDecideComp)),
      prove(make(device, "prove", spirv::kTriProveComp)),
      countKept(make(device, "count kept", spirv::kTriCountKeptComp)),
      sumKept(make(device, "sum kept", spirv::kTriSumKeptComp)),
      writeKept(make(device, "write kept", spirv::kTriWriteKeptComp)) {}

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

void DeviceForest::begin(Frame& frame, const Kernel& program, std::uint32_t stage, std::uint32_t firstTree) const {
    frame.beginStage(program.name);
    program.pipeline.bind(frame.commands());
    program.pipeline.push(frame.commands(), kernel::Push{{m_forest.address()}, stage, firstTree});
}

void DeviceForest::dispatch(Frame& frame, const Kernel& program, std::uint32_t groups, std::uint32_t firstTree) const {
    begin(frame, program, 0, firstTree);
    // Workgroups in rows, as advance.h lays them out.
    constexpr std::uint32_t kRow = kernel::kMaxGroupsX;
    vkCmdDispatch(frame.commands(), std::min(groups, kRow), (groups + kRow - 1) / kRow, 1);
    finishBefore(frame.commands());
}

/// As many workgroups as the device wrote to the member of Control that lies `groups` bytes into it.
void DeviceForest::run(Frame& frame, const Kernel& program, std::size_t groups, std::uint32_t stage) const {
    begin(frame, program, stage, 0);
    vkCmdDispatchIndirect(frame.commands(), column(offsetof(kernel::Forest, control)).handle(), groups);
    finishBefore(frame.commands());
}

void DeviceForest::recordInit(Frame& frame, const Kernels& kernels) const {
    const Buffer& found = column(offsetof(kernel::Forest, found));
    vkCmdFillBuffer(frame.commands(), found.handle(), 0, VK_WHOLE_SIZE, 0);
    render::gpu::memoryBarrier(frame.commands(), render::gpu::kCopyWrite, render::gpu::kCompute);
    dispatch(frame, kernels.init, (m_record.vertexCount + kernel::kGroupSize - 1) / kernel::kGroupSize);
}

void DeviceForest::recordSmall(Frame& frame, const Kernels& kernels) const {
    if (m_record.tinyTrees > 0) {
        dispatch(frame, kernels.tiny, m_record.tinyTrees);
    }
    if (m_record.smallTrees > 0) {
        dispatch(frame, kernels.small, m_record.smallTrees, m_record.tinyTrees);
    }
}

void DeviceForest::recordStep(Frame& frame, const Kernels& kernels) const {
    using kernel::Control;
    dispatch(frame, kernels.advance, 1);
    run(frame, kernels.vote, offsetof(Control, insertGroups));
    run(frame, kernels.claimPlace, offsetof(Control, insertGroups));
    run(frame, kernels.split, offsetof(Control, electedGroups));
    run(frame, kernels.fixLinks, offsetof(Control, splitGroups), kernel::kStageInsert);
    run(frame, kernels.relocateInserted, offsetof(Control, insertGroups));
    run(frame, kernels.findContours, offsetof(Control, contourGroups));
    run(frame, kernels.claimCorridor, offsetof(Control, edgeGroups));
    run(frame, kernels.rebuildCorridor, offsetof(Control, edgeGroups));
    run(frame, kernels.fixLinks, offsetof(Control, contourGroups), kernel::kStageRebuild);
    run(frame, kernels.testEdges, offsetof(Control, flipGroups));
    run(frame, kernels.flip, offsetof(Control, flipGroups));
    run(frame, kernels.fixFlips, offsetof(Control, flipGroups));
    run(frame, kernels.relocateFlipped, offsetof(Control, relocateGroups));
    dispatch(frame, kernels.tail, 1);
}

void DeviceForest::recordErase(Frame& frame, const Kernels& kernels) const {
    const std::uint32_t slots = 2 * m_record.vertexCount;
    const std::uint32_t groups = (slots + kernel::kGroupSize - 1) / kernel::kGroupSize;
    const std::uint32_t blocks = (slots + kernel::kBlockSize - 1) / kernel::kBlockSize;
    dispatch(frame, kernels.decide, groups);
    dispatch(frame, kernels.prove, groups);
    dispatch(frame, kernels.countKept, blocks);
    dispatch(frame, kernels.sumKept, 1);
    dispatch(frame, kernels.writeKept, blocks);
}

kernel::Control DeviceForest::control() const {
    const auto controls = read<kernel::Control>(offsetof(kernel::Forest, control), 1);
    return controls.empty() ? kernel::Control{} : controls.front();
}

}  // namespace tri::gpu
