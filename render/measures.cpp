#include "render/measures.h"

#include "render/gpu/barrier.h"
#include "render/scene_buffers.h"

namespace render {
namespace {

template <class... T>
std::uint64_t sizeOf(const std::vector<T>&... columns) {
    return (std::uint64_t{0} + ... + (columns.capacity() * sizeof(T)));
}

/// Copies a buffer of commands to the host.
template <class T>
std::optional<std::vector<T>> readBack(gpu::Device& device, const gpu::Buffer& buffer, std::size_t count) {
    const gpu::Buffer host(device, {"measures", count * sizeof(T), gpu::MemoryUse::Staging, true});
    gpu::FrameRing ring(device, 1, "measures");
    gpu::Frame* frame = ring.begin();
    if (frame == nullptr) {
        return std::nullopt;
    }
    gpu::memoryBarrier(frame->commands(), gpu::kAnything, gpu::kAnything);
    const VkBufferCopy region{0, 0, std::max<std::uint64_t>(count * sizeof(T), 4)};
    vkCmdCopyBuffer(frame->commands(), buffer.handle(), host.handle(), 1, &region);
    gpu::memoryBarrier(frame->commands(), gpu::kCopyWrite, gpu::kHostRead);
    if (!ring.end() || !ring.wait()) {
        return std::nullopt;
    }
    std::vector<T> values(count);
    std::memcpy(values.data(), host.mapped().data(), count * sizeof(T));
    return values;
}

std::uint64_t standardTriangles(const FramePlan& plan, const StandardBuffers& buffers) {
    std::uint64_t sum = 0;
    for (const LayerBatch& batch : plan.batches) {
        for (const std::uint32_t layer : batch.layers) {
            const LayerRun run = buffers.partsOfLayer[layer];
            for (std::uint32_t part = run.first; part < run.first + run.count; ++part) {
                sum += buffers.indexCounts[part] / 3;
            }
        }
    }
    return sum;
}

std::optional<std::uint64_t> letTriangles(BoardScene::Impl& scene, std::size_t batches) {
    const auto draws =
        readBack<shader::DrawIndexed>(*scene.device, scene.transient.letDraws, batches * shader::kBucketCount);
    if (!draws) {
        return std::nullopt;
    }
    std::uint64_t sum = 0;
    for (const shader::DrawIndexed& draw : *draws) {
        sum += std::uint64_t{draw.indexCount / 3} * draw.instanceCount;
    }
    return sum;
}

std::optional<std::uint64_t> areaTriangles(BoardScene::Impl& scene, const FramePlan& plan) {
    const auto caps = readBack<shader::DrawIndexed>(*scene.device, scene.transient.capDraws, scene.areaDrawCount);
    const auto walls = readBack<shader::Draw>(*scene.device, scene.transient.wallDraws, scene.areaDrawCount);
    if (!caps || !walls) {
        return std::nullopt;
    }
    std::uint64_t sum = 0;
    for (std::size_t layer = 0; layer < scene.layers.layers.size(); ++layer) {
        const SeenFaces& faces = plan.facesOfLayers[layer];
        const std::uint64_t capsSeen = (faces.upper ? 1U : 0U) + (faces.lower ? 1U : 0U);
        const LayerRun run = scene.layers.layers[layer].areaBatches;
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            sum += capsSeen * ((*caps)[i].indexCount / 3) * (*caps)[i].instanceCount;
            sum += (faces.walls ? 1U : 0U) * std::uint64_t{(*walls)[i].vertexCount / 3} * (*walls)[i].instanceCount;
        }
    }
    return sum;
}

}  // namespace

std::uint64_t cpuBytes(const BoardModel& m) {
    return sizeOf(m.lets, m.clusters, m.clustersOfLayer, m.vertices, m.next, m.indices, m.shapes, m.instances,
                  m.areaBatches, m.areaBatchesOfLayer, m.layerBottomMm, m.layerTopMm);
}

std::uint64_t cpuBytes(const StandardModel& model) {
    std::uint64_t sum = sizeOf(model.parts);
    for (const StandardPart& part : model.parts) {
        sum += sizeOf(part.vertices, part.indices);
    }
    return sum;
}

std::optional<std::uint64_t> drawnTriangles(BoardScene& board, const Camera& camera, const ViewSettings& settings,
                                            std::uint32_t width, std::uint32_t height) {
    BoardScene::Impl& scene = board.impl();
    const FramePlan plan = planFrame(scene.layers, camera, settings, width, height);
    if (scene.standard) {
        return standardTriangles(plan, *scene.standard);
    }
    const std::optional<std::uint64_t> lets = letTriangles(scene, plan.batches.size());
    const std::optional<std::uint64_t> areas = areaTriangles(scene, plan);
    return lets && areas ? std::optional(*lets + *areas) : std::nullopt;
}

}  // namespace render
