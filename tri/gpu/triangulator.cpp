#include "tri/gpu/triangulator.h"

#include <algorithm>

#include "model/base/parallel.h"
#include "render/gpu/check.h"

namespace tri::gpu {

namespace kernel = shader::tri;

namespace {

/// Steps per submission. More would be recorded in vain for small boards, fewer means more waiting for large ones.
constexpr int kStepsAtOnce = 16;
/// No input has been seen that takes a tenth of it.
constexpr std::uint32_t kMaxSteps = 50'000;
/// Of the largest column, and of all of them.
constexpr std::uint64_t kColumnBytesPerVertex = 2 * sizeof(kernel::Triangle);
constexpr std::uint64_t kBytesPerVertex = 256;

std::size_t verticesThatFit(const render::gpu::Caps& caps) {
    const std::uint64_t byColumn = caps.maxAllocationBytes / kColumnBytesPerVertex;
    const std::uint64_t byBudget = caps.memoryBudgetBytes / 2 / kBytesPerVertex;
    return static_cast<std::size_t>(std::min({std::uint64_t{kMaxForestVertices} - 1, byColumn, byBudget}));
}

}  // namespace

Triangulator::Triangulator(render::gpu::Device& device)
    : m_device(&device), m_ring(device, 2, "triangulation"), m_kernels(device) {}

/// A run of polygons that fit into the device's memory together; returns its end.
std::size_t Triangulator::endOfTurn(std::span<const Polygon> polygons, std::size_t first) const {
    std::size_t room = verticesThatFit(m_device->caps());
    std::size_t end = first;
    for (; end < polygons.size(); ++end) {
        const std::size_t size = forestVertices(polygons.subspan(end, 1));
        if (size > room) {
            break;
        }
        room -= size;
    }
    return end;
}

/// Submits steps until all is done; false if that does not happen.
bool Triangulator::grow(const DeviceForest& forest, base::Progress& progress) {
    kernel::Control control{};
    for (bool isFirst = true; control.phase != kernel::kFinished; isFirst = false) {
        render::gpu::Frame* frame = m_ring.begin();
        if (frame == nullptr || control.step > kMaxSteps || progress.isCancelled()) {
            return false;
        }
        if (isFirst) {
            forest.recordInit(*frame, m_kernels);
            forest.recordSmall(*frame, m_kernels);
        }
        for (int i = 0; i < kStepsAtOnce; ++i) {
            forest.recordStep(*frame, m_kernels);
        }
        forest.recordErase(*frame, m_kernels);
        if (!m_ring.end() || !m_ring.wait()) {
            return false;
        }
        m_tally.deviceMs += m_ring.gpuMs();
        for (const auto& [name, ms] : m_ring.stages()) {
            m_tally.stageMs[name] += ms;
        }
        control = forest.control();
        progress.setFraction(static_cast<float>(control.inserted) / static_cast<float>(std::max(control.total, 1U)));
    }
    m_tally.steps += control.step;
    m_tally.rounds += control.rounds;
    m_tally.flips += control.flips;
    return !forest.isLost();
}

void Triangulator::harvest(const DeviceForest& forest, const ForestData& data, std::span<Triangulation> results) {
    const std::size_t kept = forest.control().kept;
    const auto trees = forest.read<kernel::Tree>(offsetof(kernel::Forest, trees), data.trees.size());
    const auto ids = forest.read<std::uint32_t>(offsetof(kernel::Forest, kept), 3 * kept);
    if (forest.isLost()) {
        return;
    }
    base::parallelFor(trees.size(), [&](std::size_t i) {
        const kernel::Tree& tree = trees[i];
        const std::size_t end = i + 1 < trees.size() ? trees[i + 1].start : kept;
        if (tree.flags != 0 || end == tree.start) {
            return;
        }
        Triangulation& result = results[data.polygonOf[i]];
        result.status.outcome = Outcome::Ok;
        result.triangles.assign(ids.data() + 3 * std::size_t{tree.start}, ids.data() + 3 * end);
    });
}

void Triangulator::triangulateBatch(std::span<const Polygon> polygons, Eraser eraser, base::Progress& progress,
                                    std::span<Triangulation> results) {
    const ForestData data = plant(polygons, eraser);
    m_tally.withoutTree += static_cast<std::size_t>(
        std::ranges::count_if(data.trees, [](const kernel::Tree& tree) { return tree.vertexCount == 0; }));
    try {
        const DeviceForest forest(*m_device, m_ring, data);
        m_tally.deviceBytes =
            std::max(m_tally.deviceBytes, m_device->memoryReport().of(render::gpu::MemoryUse::Transient));
        if (grow(forest, progress)) {
            harvest(forest, data, results);
        }
    } catch (const render::gpu::OutOfMemory&) {
        m_device->waitIdle();  // frees what was made; the CPU takes this turn
    }
}

std::vector<Triangulation> Triangulator::triangulate(std::span<const Polygon> polygons, base::Progress& progress,
                                                     Eraser eraser) {
    m_tally = {};
    std::vector<Triangulation> results(polygons.size(), {{Outcome::Degenerate, kNoEdge, kNoEdge}, {}});
    for (std::size_t first = 0; first < polygons.size();) {
        const std::size_t end = endOfTurn(polygons, first);
        if (end > first) {
            triangulateBatch(polygons.subspan(first, end - first), eraser, progress,
                             std::span(results).subspan(first, end - first));
        } else {
            ++m_tally.withoutTree;  // too large for this device
        }
        first = std::max(end, first + 1);
    }
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].triangles.empty()) {
            left.push_back(i);
        }
    }
    base::parallelFor(left.size(), [&](std::size_t i) {
        if (progress.isCancelled()) {
            return;
        }
        Triangulation& result = results[left[i]];
        result.status = tri::triangulate(polygons[left[i]], tri::Triangulator::Auto, result.triangles);
    });
    m_tally.onDevice = polygons.size() - left.size();
    m_tally.flagged = left.size() - std::min(left.size(), m_tally.withoutTree);
    return results;
}

}  // namespace tri::gpu
