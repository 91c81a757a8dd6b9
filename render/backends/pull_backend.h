#pragma once

#include "render/backends/let_backend.h"

namespace render {

/// Compute culling sorts lets into instanced indirect draws, one for each topology and level of detail of a batch;
/// quads are drawn by groups. What an instance draws is up to its pipelines.
class PullBackend : public LetBackend {
public:
    /// Makes its pipelines at once.
    PullBackend(gpu::Device& device, const TargetFormat& target);

    void reset(const Recording& recording) override;
    void cull(std::span<const Recording> recordings) override;
    void draw(const Recording& recording, std::uint32_t batch, gpu::Pass pass) override;

protected:
    /// Leaves pipelines to whoever derives from it.
    explicit PullBackend(gpu::Device& device);
    /// Indices that each instance of a draw of a batch takes.
    [[nodiscard]] virtual IndexRun runOf(const Recording& recording, std::uint32_t draw) const;
    [[nodiscard]] virtual const PassPipelines& pipelinesFor(const FramePlan&) { return m_pipelines; }

private:
    [[nodiscard]] std::vector<shader::DrawIndexed> emptyDraws(const Recording& recording) const;

    gpu::Pipeline m_cullClusters;
    gpu::Pipeline m_cullLets;
    gpu::Pipeline m_lineUpDraws;
    gpu::Pipeline m_placeLets;
    PassPipelines m_pipelines;
};

/// Records one workgroup for each cluster in view, after all work before.
void dispatchForClusters(const gpu::Pipeline& pipeline, std::span<const Recording> recordings);

}  // namespace render
