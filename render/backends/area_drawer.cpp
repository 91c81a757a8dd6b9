#include "render/backends/area_drawer.h"

#include <algorithm>

#include "shaders/spirv.h"

namespace render {
namespace {

PassPipelines makePipelines(gpu::Device& device, std::string_view label, gpu::Spirv vertexShader, bool cullsBackFaces,
                            const TargetFormat& target) {
    return makePassPipelines(device, label, gpu::drawStages(vertexShader, shader::spirv::kBoardFrag), cullsBackFaces,
                             target);
}

void copyTo(VkCommandBuffer commands, const gpu::Buffer& from, const BufferPart& to) {
    if (to.size > 0) {
        const VkBufferCopy region{0, to.offset, to.size};
        vkCmdCopyBuffer(commands, from.handle(), to.buffer, 1, &region);
    }
}

/// Runs of area batches on layers of which `side` is seen; neighbouring layers join.
std::vector<LayerRun> runsOf(const Recording& recording, std::uint32_t batch, bool SeenFaces::*side) {
    std::vector<LayerRun> runs;
    for (const std::uint32_t layer : recording.layers.batches[batch]) {
        const LayerRun run = recording.step.layers[layer].areaBatches;
        if (run.count == 0 || !(recording.layers.faces[layer].*side)) {
            continue;
        }
        if (!runs.empty() && runs.back().first + runs.back().count == run.first) {
            runs.back().count += run.count;
        } else {
            runs.push_back(run);
        }
    }
    return runs;
}

/// Calls `draw(first, count)` in pieces the device takes at once.
template <class Draw>
void forPieces(std::span<const LayerRun> runs, std::uint32_t largest, const Draw& draw) {
    for (const LayerRun& run : runs) {
        for (std::uint32_t done = 0; done < run.count; done += largest) {
            draw(run.first + done, std::min(largest, run.count - done));
        }
    }
}

}  // namespace

AreaDrawer::AreaDrawer(gpu::Device& device, const TargetFormat& target)
    : m_maxDraws(device.caps().maxDrawIndirectCount),
      m_cull(device, {"cull areas", shader::spirv::kCullAreasComp, sizeof(shader::Push)}),
      m_caps(makePipelines(device, "area caps", shader::spirv::kAreaCapVert, false, target)),
      m_patches(makePipelines(device, "area patches", shader::spirv::kAreaPatchVert, false, target)),
      m_walls(makePipelines(device, "area walls", shader::spirv::kAreaWallVert, true, target)),
      m_outlines(makePipelines(device, "area outlines", shader::spirv::kAreaOutlineVert, false, target)) {}

void AreaDrawer::reset(const Recording& recording) const {
    copyTo(recording.commands(), recording.step.geometry.capDraws, recording.lists.capDraws);
    copyTo(recording.commands(), recording.step.geometry.wallDraws, recording.lists.wallDraws);
    copyTo(recording.commands(), recording.step.geometry.patchDraws, recording.lists.patchDraws);
}

void AreaDrawer::cull(const Recording& recording) const {
    recording.bind(m_cull);
    const std::uint32_t groups = (recording.step.instanceCount + shader::kCullGroupSize - 1) / shader::kCullGroupSize;
    vkCmdDispatch(recording.commands(), groups, 1, 1);
}

void AreaDrawer::draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) const {
    const bool seesUpper = recording.plan.data.quadFace == 0;
    if ((recording.plan.data.flags & shader::kFrameOutlines) != 0) {
        drawEdges(recording, pass, batch, m_outlines, seesUpper ? &SeenFaces::upper : &SeenFaces::lower);
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
    constexpr std::uint32_t kStride = sizeof(shader::DrawIndexed);
    forPieces(runsOf(recording, batch, face == 0 ? &SeenFaces::upper : &SeenFaces::lower), m_maxDraws,
              [&](std::uint32_t first, std::uint32_t count) {
                  vkCmdDrawIndexedIndirect(recording.commands(), recording.lists.capDraws.buffer,
                                           recording.lists.capDraws.offset + std::uint64_t{first} * kStride, count,
                                           kStride);
              });
}

void AreaDrawer::drawPatches(const Recording& recording, gpu::Pass pass, std::uint32_t batch) const {
    if (recording.plan.data.quadRadiusPx == 0.0F) {
        return;
    }
    recording.bind(m_patches[passRow(pass)]);
    for (const std::uint32_t layer : recording.layers.batches[batch]) {
        if (recording.step.layers[layer].areaBatches.count > 0) {
            vkCmdDrawIndirect(recording.commands(), recording.lists.patchDraws.buffer,
                              recording.lists.patchDraws.offset + layer * sizeof(shader::Draw), 1,
                              sizeof(shader::Draw));
        }
    }
}

void AreaDrawer::drawEdges(const Recording& recording, gpu::Pass pass, std::uint32_t batch,
                           const PassPipelines& pipelines, bool SeenFaces::*side) const {
    recording.bind(pipelines[passRow(pass)]);
    constexpr std::uint32_t kStride = sizeof(shader::Draw);
    forPieces(runsOf(recording, batch, side), m_maxDraws, [&](std::uint32_t first, std::uint32_t count) {
        vkCmdDrawIndirect(recording.commands(), recording.lists.wallDraws.buffer,
                          recording.lists.wallDraws.offset + std::uint64_t{first} * kStride, count, kStride);
    });
}

}  // namespace render
