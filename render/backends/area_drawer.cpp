#include "render/backends/area_drawer.h"

#include "shaders/spirv.h"

namespace render {
namespace {

PassPipelines makePipelines(gpu::Device& device, std::string_view label, gpu::Spirv vertexShader, bool cullsBackFaces,
                            const TargetFormat& target) {
    return makePassPipelines(device, label, gpu::drawStages(vertexShader, shader::spirv::kBoardFrag), cullsBackFaces,
                             target);
}

/// Where the draws of a run are.
struct RunOfDraws {
    std::uint64_t firstDraw = 0;
    std::uint64_t countOffset = 0;  ///< in the buffer of DrawLists::commandCounts
    std::uint32_t most = 0;
};

/// Calls `draw` with each run of areas of a batch on layers of which `side` is seen.
template <class Draw>
void forRuns(const Recording& recording, std::uint32_t batch, bool SeenFaces::*side, const Draw& draw) {
    for (const std::uint32_t layer : recording.layers.batches[batch]) {
        if (!(recording.layers.faces[layer].*side)) {
            continue;
        }
        const LayerRun runs = recording.step.layers[layer].areas;
        for (std::uint32_t i = runs.first; i < runs.first + runs.count; ++i) {
            const shader::AreaRun& run = recording.step.areaRuns[i];
            draw(RunOfDraws{run.first, recording.lists.commandCounts.offset + i * sizeof(std::uint32_t), run.count});
        }
    }
}

}  // namespace

AreaDrawer::AreaDrawer(gpu::Device& device, const TargetFormat& target)
    : m_cull(device, {"cull areas", shader::spirv::kCullAreasComp, sizeof(shader::Push)}),
      m_lineUp(device, {"line up areas", shader::spirv::kLineUpAreasComp, sizeof(shader::Push)}),
      m_caps(makePipelines(device, "area caps", shader::spirv::kAreaCapVert, false, target)),
      m_patches(makePipelines(device, "area patches", shader::spirv::kAreaPatchVert, false, target)),
      m_walls(makePipelines(device, "area walls", shader::spirv::kAreaWallVert, true, target)),
      m_makeOutlines([&device, target] {
          return makePipelines(device, "area outlines", shader::spirv::kAreaOutlineVert, false, target);
      }) {}

void AreaDrawer::reset(const Recording& recording) const {
    const DrawLists& lists = recording.lists;
    if (lists.areaCounts.size > 0) {
        vkCmdFillBuffer(recording.commands(), lists.areaCounts.buffer, lists.areaCounts.offset, lists.areaCounts.size,
                        0);
        const VkBufferCopy patches{0, lists.patchDraws.offset, lists.patchDraws.size};
        vkCmdCopyBuffer(recording.commands(), recording.step.geometry.patchDraws.handle(), lists.patchDraws.buffer, 1,
                        &patches);
    }
}

void AreaDrawer::cull(const Recording& recording) const {
    recording.bind(m_cull);
    dispatchCull(recording.commands(), recording.step.instanceCount);
}

void AreaDrawer::lineUp(const Recording& recording) const {
    recording.bind(m_lineUp);
    vkCmdDispatch(recording.commands(), static_cast<std::uint32_t>(recording.step.areaRuns.size()), 1, 1);
}

void AreaDrawer::draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) {
    const bool seesUpper = recording.plan.data.quadFace == 0;
    if ((recording.plan.data.flags & shader::kFrameOutlines) != 0) {
        if (!m_outlines) {
            m_outlines = m_makeOutlines();
        }
        drawEdges(recording, pass, batch, *m_outlines, seesUpper ? &SeenFaces::upper : &SeenFaces::lower);
        return;
    }
    drawCaps(recording, pass, batch, 0);
    drawCaps(recording, pass, batch, 1);
    drawPatches(recording, pass, batch);
    drawEdges(recording, pass, batch, m_walls, &SeenFaces::walls);
}

void AreaDrawer::drawCaps(const Recording& recording, gpu::Pass pass, std::uint32_t batch, std::uint32_t face) const {
    recording.bind(m_caps[passRow(pass)], 0, face);
    vkCmdBindIndexBuffer(recording.commands(), recording.step.geometry.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    const DrawLists& lists = recording.lists;
    forRuns(recording, batch, face == 0 ? &SeenFaces::upper : &SeenFaces::lower, [&](const RunOfDraws& run) {
        constexpr std::uint32_t kStride = sizeof(shader::DrawIndexed);
        vkCmdDrawIndexedIndirectCount(recording.commands(), lists.capDraws.buffer,
                                      lists.capDraws.offset + run.firstDraw * kStride, lists.commandCounts.buffer,
                                      run.countOffset, run.most, kStride);
    });
}

void AreaDrawer::drawPatches(const Recording& recording, gpu::Pass pass, std::uint32_t batch) const {
    if (recording.plan.data.quadRadiusPx == 0.0F) {
        return;
    }
    recording.bind(m_patches[passRow(pass)]);
    for (const std::uint32_t layer : recording.layers.batches[batch]) {
        if (recording.step.layers[layer].areas.count > 0) {
            vkCmdDrawIndirectCount(recording.commands(), recording.lists.patchDraws.buffer,
                                   recording.lists.patchDraws.offset + layer * sizeof(shader::Draw),
                                   recording.step.geometry.countOfAll.handle(), 0, 1, sizeof(shader::Draw));
        }
    }
}

void AreaDrawer::drawEdges(const Recording& recording, gpu::Pass pass, std::uint32_t batch,
                           const PassPipelines& pipelines, bool SeenFaces::*side) const {
    recording.bind(pipelines[passRow(pass)]);
    const DrawLists& lists = recording.lists;
    forRuns(recording, batch, side, [&](const RunOfDraws& run) {
        constexpr std::uint32_t kStride = sizeof(shader::Draw);
        vkCmdDrawIndirectCount(recording.commands(), lists.wallDraws.buffer,
                               lists.wallDraws.offset + run.firstDraw * kStride, lists.commandCounts.buffer,
                               run.countOffset, run.most, kStride);
    });
}

}  // namespace render
