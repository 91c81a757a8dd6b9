#include "render/backends/pull_backend.h"
#include "shaders/spirv.h"

namespace render {
namespace {

class ImpostorBackend : public PullBackend {
public:
    ImpostorBackend(gpu::Device& device, const TargetFormat& target)
        : PullBackend(device), m_device(&device), m_target(target) {}

    [[nodiscard]] bool isReadyFor(bool isFlat) const override { return bool((isFlat ? m_faces : m_boxes).front()); }

    void makeReadyFor(bool isFlat) override {
        if (isReadyFor(isFlat)) {
            return;
        }
        if (isFlat) {
            m_faces = make("lets (impostor)", shader::spirv::kLetImpostorVert, shader::spirv::kLetImpostorFrag,
                           gpu::Cover::Fragments);
        } else {
            m_boxes = make("lets (impostor boxes)", shader::spirv::kLetBoxVert, shader::spirv::kLetBoxFrag,
                           gpu::Cover::Samples);
        }
    }

private:
    [[nodiscard]] IndexRun runOf(const Recording& recording, std::uint32_t draw) const override {
        return isFlatView(recording.plan) ? PullBackend::runOf(recording, draw)
                                          : recording.scene.letTables.boxRun(draw, recording.plan.faces);
    }

    [[nodiscard]] const PassPipelines& pipelinesFor(const FramePlan& plan) override {
        makeReadyFor(isFlatView(plan));
        return isFlatView(plan) ? m_faces : m_boxes;
    }

    [[nodiscard]] PassPipelines make(std::string_view label, gpu::Spirv vertexShader, gpu::Spirv fragmentShader,
                                     gpu::Cover cover) const {
        return makePassPipelines(*m_device, label, gpu::drawStages(vertexShader, fragmentShader), true, m_target,
                                 cover);
    }

    gpu::Device* m_device;
    TargetFormat m_target;
    PassPipelines m_faces;  ///< for flat views; made when first needed, these too
    PassPipelines m_boxes;
};

}  // namespace

std::unique_ptr<LetBackend> makeImpostorBackend(gpu::Device& device, const TargetFormat& target) {
    return std::make_unique<ImpostorBackend>(device, target);
}

}  // namespace render
