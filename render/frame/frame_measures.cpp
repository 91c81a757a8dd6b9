#include "render/frame/frame_measures.h"

#include "render/frame/frame_copies.h"
#include "render/gpu/check.h"
#include "render/scene/scene_buffers.h"

namespace render {
namespace {

template <class... T>
std::uint64_t sizeOf(const std::vector<T>&... columns) {
    return (std::uint64_t{0} + ... + (columns.capacity() * sizeof(T)));
}

/// Copies commands to the host.
template <class T>
std::optional<std::vector<T>> readBack(gpu::Device& device, const BufferPart& part, std::size_t count) {
    std::vector<T> values(count);
    gpu::FrameRing ring(device, 1, "measures");
    const auto bytes = std::as_writable_bytes(std::span(values));
    return gpu::download(device, ring, part.buffer, bytes, part.offset) ? std::optional(std::move(values))
                                                                        : std::nullopt;
}

std::uint64_t standardTriangles(const LayerPlan& plan, const StandardBuffers& buffers) {
    std::uint64_t sum = 0;
    for (const LayerBatch& batch : plan.batches) {
        for (const std::uint32_t layer : batch) {
            const LayerRun run = buffers.partsOfLayer[layer];
            for (std::uint32_t part = run.first; part < run.first + run.count; ++part) {
                sum += buffers.indexCounts[part] / 3;
            }
        }
    }
    return sum;
}

std::uint64_t trianglesOf(std::span<const shader::DrawIndexed> draws) {
    std::uint64_t sum = 0;
    for (const shader::DrawIndexed& draw : draws) {
        sum += std::uint64_t{draw.indexCount / 3} * draw.instanceCount;
    }
    return sum;
}

std::uint64_t trianglesOf(std::span<const shader::Draw> draws) {
    std::uint64_t sum = 0;
    for (const shader::Draw& draw : draws) {
        sum += std::uint64_t{draw.vertexCount / 3} * draw.instanceCount;
    }
    return sum;
}

std::optional<std::uint64_t> letTriangles(const Recording& copy) {
    const auto draws = readBack<shader::DrawIndexed>(*copy.scene.device, copy.lists.letDraws,
                                                     copy.layers.batches.size() * shader::kDrawCount);
    return draws ? std::optional(trianglesOf(*draws)) : std::nullopt;
}

std::optional<std::uint64_t> areaTriangles(const Recording& copy) {
    const std::uint32_t count = copy.step.areaDrawCount;
    const auto counts =
        readBack<std::uint32_t>(*copy.scene.device, copy.lists.commandCounts, copy.step.areaRuns.size());
    const auto caps = readBack<shader::DrawIndexed>(*copy.scene.device, copy.lists.capDraws, count);
    const auto walls = readBack<shader::Draw>(*copy.scene.device, copy.lists.wallDraws, count);
    const auto patches = readBack<shader::Draw>(*copy.scene.device, copy.lists.patchDraws, copy.step.layers.size());
    if (!counts || !caps || !walls || !patches) {
        return std::nullopt;
    }
    std::uint64_t sum = 0;
    for (std::size_t layer = 0; layer < copy.step.layers.size(); ++layer) {
        const SeenFaces& faces = copy.layers.faces[layer];
        const std::uint64_t capsSeen = (faces.upper ? 1U : 0U) + (faces.lower ? 1U : 0U);
        const LayerRun runs = copy.step.layers[layer].areas;
        sum += (*patches)[layer].vertexCount / 3;
        for (std::uint32_t run = runs.first; run < runs.first + runs.count; ++run) {
            const std::uint32_t first = copy.step.areaRuns[run].first;
            sum += capsSeen * trianglesOf(std::span(*caps).subspan(first, (*counts)[run]));
            sum += (faces.walls ? 1U : 0U) * trianglesOf(std::span(*walls).subspan(first, (*counts)[run]));
        }
    }
    return sum;
}

/// Of all copies; none when several groups of them took turns in the draw lists, which then report the last one only.
std::optional<std::uint64_t> hybridTriangles(const std::vector<CopyGroup>& groups) {
    std::uint64_t sum = 0;
    for (const CopyGroup& group : groups) {
        for (const Recording& copy : group) {
            const std::optional<std::uint64_t> lets = letTriangles(copy);
            const std::optional<std::uint64_t> areas = areaTriangles(copy);
            if (!lets || !areas || groups.size() > 1) {
                return std::nullopt;
            }
            sum += *lets + *areas;
        }
    }
    return sum;
}

/// Rec. 601 luma of a pixel, 0 to 1.
double grey(const Image& image, std::size_t pixel) {
    const std::uint8_t* rgba = &image.rgba[4 * pixel];
    return (0.299 * rgba[0] + 0.587 * rgba[1] + 0.114 * rgba[2]) / 255.0;
}

}  // namespace

std::uint64_t cpuBytes(const BoardModel& m) {
    std::uint64_t sum = sizeOf(m.lets, m.clusters, m.clustersOfLayer, m.vertices, m.next, m.indices, m.shapes,
                               m.instances, m.areaBatches, m.areaBatchesOfLayer, m.layers, m.copies);
    for (const BoardModel& step : m.steps) {
        sum += cpuBytes(step);
    }
    return sum;
}

std::uint64_t cpuBytes(const StandardModel& model) {
    std::uint64_t sum = sizeOf(model.parts);
    for (const StandardPart& part : model.parts) {
        sum += sizeOf(part.vertices, part.indices);
    }
    for (const StandardModel& step : model.steps) {
        sum += cpuBytes(step);
    }
    return sum;
}

double greyMse(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.rgba.empty()) {
        return 1.0;
    }
    const std::size_t pixels = std::size_t{a.width} * a.height;
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double difference = grey(a, i) - grey(b, i);
        sum += difference * difference;
    }
    return sum / static_cast<double>(pixels);
}

std::optional<std::uint64_t> drawnTriangles(BoardScene& board, const Camera& camera, const ViewSettings& settings,
                                            std::uint32_t width, std::uint32_t height) {
    BoardScene::Impl& scene = board.impl();
    const FramePlan plan = planFrame(scene.layers, camera, settings, width, height);
    if (scene.steps.front().standard) {
        std::uint64_t sum = 0;
        for (const ModelCopy& copy : scene.copies) {
            sum += standardTriangles(copy.isFlipped ? plan.flipped : plan.upright, *scene.steps[copy.step].standard);
        }
        return sum;
    }
    try {
        gpu::FrameRing ring(*scene.device, 1, "measures");
        gpu::Frame* frame = ring.begin();
        if (frame == nullptr) {
            return std::nullopt;
        }
        const std::optional<std::uint64_t> sum = hybridTriangles(copiesInView(*frame, plan, scene));
        return ring.end() && ring.wait() ? sum : std::nullopt;
    } catch (const gpu::OutOfMemory&) {
        return std::nullopt;
    }
}

}  // namespace render
