#include "tri/gpu/triangulator.h"

#include <algorithm>
#include <cstring>

#include "model/base/parallel.h"
#include "render/gpu/check.h"
#include "tri/gpu/device_forest.h"

namespace tri::gpu {

namespace kernel = shader::tri;

namespace {

/// Steps per submission. More would be recorded in vain for small boards, fewer means more waiting for large ones.
constexpr int kStepsAtOnce = 32;
/// No input has been seen that takes a tenth of it.
constexpr std::uint32_t kMaxSteps = 50'000;
/// Of the largest column, and of all of them.
constexpr std::uint64_t kColumnBytesPerVertex = 24;
constexpr std::uint64_t kBytesPerVertex = 256;

std::size_t verticesThatFit(const render::gpu::Caps& caps) {
    const std::uint64_t byColumn = caps.maxAllocationBytes / kColumnBytesPerVertex;
    const std::uint64_t byBudget = caps.memoryBudgetBytes / 2 / kBytesPerVertex;
    return static_cast<std::size_t>(std::min({std::uint64_t{kMaxForestVertices} - 1, byColumn, byBudget}));
}

}  // namespace

struct Triangulator::State {
    render::gpu::Device* device;
    render::gpu::FrameRing ring;
    Kernels kernels;
    Tally tally;

    explicit State(render::gpu::Device& on) : device(&on), ring(on, 2, "triangulation"), kernels(on) {}

    /// A run of polygons that fit into the device's memory together; returns its end.
    [[nodiscard]] std::size_t endOfTurn(std::span<const Polygon> polygons, std::size_t first) const;
    void triangulateBatch(std::span<const Polygon> polygons, Eraser eraser, base::Progress& progress,
                          std::span<Triangulation> results);
    [[nodiscard]] bool grow(const DeviceForest& forest, base::Progress& progress);
    void harvest(const DeviceForest& forest, const ForestData& data, std::span<Triangulation> results);
};

std::size_t Triangulator::State::endOfTurn(std::span<const Polygon> polygons, std::size_t first) const {
    std::size_t room = verticesThatFit(device->caps());
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
bool Triangulator::State::grow(const DeviceForest& forest, base::Progress& progress) {
    kernel::Control control{};
    for (bool isFirst = true; control.phase != kernel::kFinished; isFirst = false) {
        const render::gpu::Frame* frame = ring.begin();
        if (frame == nullptr || control.step > kMaxSteps || progress.isCancelled()) {
            return false;
        }
        if (isFirst) {
            forest.recordInit(frame->commands(), kernels);
            forest.recordSmall(frame->commands(), kernels);
        }
        for (int i = 0; i < kStepsAtOnce; ++i) {
            forest.recordStep(frame->commands(), kernels);
        }
        forest.recordErase(frame->commands(), kernels);
        if (!ring.end() || !ring.wait()) {
            return false;
        }
        tally.deviceMs += ring.gpuMs();
        control = forest.control();
        progress.setFraction(static_cast<float>(control.inserted) / static_cast<float>(std::max(control.total, 1U)));
    }
    tally.steps += control.step;
    tally.rounds += control.rounds;
    tally.flips += control.flips;
    return !forest.isLost();
}

void Triangulator::State::harvest(const DeviceForest& forest, const ForestData& data,
                                  std::span<Triangulation> results) {
    const std::size_t kept = forest.control().kept;
    const auto trees = forest.read(offsetof(kernel::Forest, trees), sizeof(kernel::Tree) * data.trees.size());
    const auto ids = forest.read(offsetof(kernel::Forest, kept), 3 * sizeof(std::uint32_t) * kept);
    if (forest.isLost()) {
        return;
    }
    const auto treeAt = [&](std::size_t i) {
        kernel::Tree tree{};
        std::memcpy(&tree, trees.data() + i * sizeof(tree), sizeof(tree));
        return tree;
    };
    base::parallelFor(data.trees.size(), [&](std::size_t i) {
        const kernel::Tree tree = treeAt(i);
        const std::size_t end = i + 1 < data.trees.size() ? treeAt(i + 1).start : kept;
        if (tree.flags != 0 || end == tree.start) {
            return;
        }
        Triangulation& result = results[data.polygonOf[i]];
        result.status.outcome = Outcome::Ok;
        result.triangles.resize(3 * (end - tree.start));
        std::memcpy(result.triangles.data(), ids.data() + 3 * sizeof(std::uint32_t) * tree.start,
                    sizeof(std::uint32_t) * result.triangles.size());
    });
}

void Triangulator::State::triangulateBatch(std::span<const Polygon> polygons, Eraser eraser, base::Progress& progress,
                                           std::span<Triangulation> results) {
    const ForestData data = plant(polygons, eraser);
    tally.withoutTree += static_cast<std::size_t>(
        std::ranges::count_if(data.trees, [](const kernel::Tree& tree) { return tree.vertexCount == 0; }));
    try {
        const DeviceForest forest(*device, ring, data);
        tally.deviceBytes = std::max(tally.deviceBytes, device->memoryReport().of(render::gpu::MemoryUse::Transient));
        if (grow(forest, progress)) {
            harvest(forest, data, results);
        }
    } catch (const render::gpu::OutOfMemory&) {
        device->waitIdle();  // frees what was made; the CPU takes this turn
    }
}

Triangulator::Triangulator(render::gpu::Device& device) : m_state(std::make_unique<State>(device)) {}
Triangulator::~Triangulator() = default;
Triangulator::Triangulator(Triangulator&&) noexcept = default;
Triangulator& Triangulator::operator=(Triangulator&&) noexcept = default;

const Tally& Triangulator::tally() const {
    return m_state->tally;
}

std::vector<Triangulation> Triangulator::triangulate(std::span<const Polygon> polygons, base::Progress& progress,
                                                     Eraser eraser) {
    m_state->tally = {};
    std::vector<Triangulation> results(polygons.size(), {{Outcome::Degenerate, kNoEdge, kNoEdge}, {}});
    for (std::size_t first = 0; first < polygons.size();) {
        const std::size_t end = m_state->endOfTurn(polygons, first);
        if (end > first) {
            m_state->triangulateBatch(polygons.subspan(first, end - first), eraser, progress,
                                      std::span(results).subspan(first, end - first));
        } else {
            ++m_state->tally.withoutTree;  // too large for this device
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
    m_state->tally.onDevice = polygons.size() - left.size();
    m_state->tally.flagged = left.size() - std::min(left.size(), m_state->tally.withoutTree);
    return results;
}

}  // namespace tri::gpu
