#include <algorithm>

#include "render/backends/let_backend.h"
#include "shaders/spirv.h"

namespace render {
namespace {

class MeshBackend : public LetBackend {
public:
    MeshBackend(gpu::Device& device, const TargetFormat& target)
        : m_drawMeshTasks(reinterpret_cast<PFN_vkCmdDrawMeshTasksEXT>(
              vkGetDeviceProcAddr(device.handle(), "vkCmdDrawMeshTasksEXT"))),
          m_maxGroups(device.caps().maxTaskGroups) {
        ASSERT(device.caps().hasMeshShader);
        const gpu::ShaderStage stages[] = {{VK_SHADER_STAGE_TASK_BIT_EXT, shader::spirv::kLetMeshTask},
                                           {VK_SHADER_STAGE_MESH_BIT_EXT, shader::spirv::kLetMeshMesh},
                                           {VK_SHADER_STAGE_FRAGMENT_BIT, shader::spirv::kBoardFrag}};
        m_pipelines = makePassPipelines(device, "lets (mesh)", stages, true, target);
    }

    void reset(const Recording&) override {}
    void cull(std::span<const Recording>) override {}

    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) override {
        m_pipelines[passRow(pass)].bind(recording.commands());
        // Neighbouring layers have neighbouring clusters: runs of visible layers are one draw.
        LayerRun run;
        for (const std::uint32_t layer : recording.layers.batches[batch]) {
            const LayerRun clusters = recording.step.layers[layer].clusters;
            if (clusters.first != run.first + run.count) {
                drawRun(recording, pass, run);
                run = {clusters.first, 0};
            }
            run.count += clusters.count;
        }
        drawRun(recording, pass, run);
    }

private:
    void drawRun(const Recording& recording, gpu::Pass pass, LayerRun run) {
        while (run.count > 0) {
            const std::uint32_t groups = std::min(run.count, m_maxGroups);
            recording.push(m_pipelines[passRow(pass)], run.first, 0);
            m_drawMeshTasks(recording.commands(), groups, 1, 1);
            run = {run.first + groups, run.count - groups};
        }
    }

    PassPipelines m_pipelines;
    PFN_vkCmdDrawMeshTasksEXT m_drawMeshTasks;
    std::uint32_t m_maxGroups;
};

}  // namespace

std::unique_ptr<LetBackend> makeMeshBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<MeshBackend>(device, target);
}

}  // namespace render
