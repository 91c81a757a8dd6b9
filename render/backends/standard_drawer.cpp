#include "render/backends/scene_drawer.h"
#include "shaders/spirv.h"

namespace render {
namespace {

class StandardDrawer : public SceneDrawer {
public:
    StandardDrawer(gpu::Device& device, const TargetFormat& target)
        : m_pipelines(makePassPipelines(device, "standard",
                                        gpu::drawStages(shader::spirv::kStandardVert, shader::spirv::kBoardFrag), true,
                                        target)) {}

    void cull(std::span<const Recording>) override {}

    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) override {
        const gpu::Pipeline& pipeline = m_pipelines[passRow(pass)];
        const StandardBuffers& buffers = *recording.step.standard;
        recording.frame.beginStage("triangles");
        pipeline.bind(recording.commands());
        for (const std::uint32_t layer : recording.layers.batches[batch]) {
            const LayerRun run = buffers.partsOfLayer[layer];
            for (std::uint32_t part = run.first; part < run.first + run.count; ++part) {
                recording.push(pipeline, part, 0);
                vkCmdBindIndexBuffer(recording.commands(), buffers.indices[part].handle(), 0, VK_INDEX_TYPE_UINT32);
                vkCmdDrawIndexed(recording.commands(), buffers.indexCounts[part], 1, 0, 0, 0);
            }
        }
    }

private:
    PassPipelines m_pipelines;
};

}  // namespace

std::unique_ptr<SceneDrawer> makeStandardDrawer(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<StandardDrawer>(device, target);
}

}  // namespace render
