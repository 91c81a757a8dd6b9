#include "render/backends/pull_backend.h"
#include "shaders/spirv.h"

namespace render {
namespace {

class ImpostorBackend : public PullBackend {
public:
    ImpostorBackend(gpu::Device& device, const TargetFormat& target)
        : PullBackend(device), m_device(&device), m_target(target) {}

private:
    [[nodiscard]] IndexRun runOf(const Recording& recording, std::uint32_t draw) const override {
        return isFlatView(recording.plan) ? PullBackend::runOf(recording, draw)
                                          : recording.scene.letTables.boxRun(draw, recording.plan.faces);
    }

    [[nodiscard]] const PassPipelines& pipelinesFor(const FramePlan& plan) override {
        PassPipelines& pipelines = isFlatView(plan) ? m_faces : m_boxes;
        if (!pipelines.front()) {
            pipelines = isFlatView(plan) ? make("lets (impostor)", shader::spirv::kLetImpostorVert,
                                                shader::spirv::kLetImpostorFrag, gpu::Cover::Fragments)
                                         : make("lets (impostor boxes)", shader::spirv::kLetBoxVert,
                                                shader::spirv::kLetBoxFrag, gpu::Cover::Samples);
        }
        return pipelines;
    }

    [[nodiscard]] PassPipelines make(std::string_view label, gpu::Spirv vertexShader, gpu::Spirv fragmentShader,
                                     gpu::Cover cover) const {
        return makePassPipelines(*m_device, label, gpu::drawStages(vertexShader, fragmentShader), true, m_target,
                                 cover);
    }

    gpu::Device* m_device;
    TargetFormat m_target;
    PassPipelines m_faces;  ///< made when first drawn with, these too
    PassPipelines m_boxes;
};

}  // namespace

std::unique_ptr<LetBackend> makeImpostorBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<ImpostorBackend>(device, target);
}

}  // namespace render
