#include "render/scene/board_scene.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "render/gpu/barrier.h"
#include "render/gpu/check.h"
#include "render/scene/scene_buffers.h"
#include "render/scene/scene_loader.h"
#include "render/scene/shape_bounds.h"
#include "render/standard/standard_model.h"

namespace render {
namespace {

using gpu::Buffer;
using gpu::MemoryUse;

/// Of one list, on every device (Vulkan's required limit).
constexpr std::uint32_t kMostCommands = 65535;

std::vector<std::uint32_t> drawOfInstance(const BoardModel& model) {
    std::vector<std::uint32_t> draws(model.instances.size());
    for (std::uint32_t i = 0; i < model.areaBatches.size(); ++i) {
        const AreaBatch& batch = model.areaBatches[i];
        std::fill_n(draws.begin() + batch.firstInstance, batch.instanceCount, i);
    }
    return draws;
}

std::vector<shader::AreaDraw> areaDraws(const BoardModel& model) {
    constexpr std::uint32_t kPerEdge = 6;
    std::vector<shader::AreaDraw> draws;
    for (const AreaBatch& batch : model.areaBatches) {
        const AreaShape& shape = model.shapes[batch.shape];
        draws.push_back({shape.triangleCount * 3, shape.firstIndex, shape.firstVertex, shape.wallCount * kPerEdge,
                         shape.firstWall * kPerEdge, batch.firstInstance});
    }
    return draws;
}

/// One by layer, with room for all areas of it.
std::vector<shader::Draw> patchDraws(const BoardModel& model, std::size_t layerCount) {
    std::vector<shader::Draw> draws(layerCount, {0, 1, 0, 0});
    for (std::size_t layer = 0; layer < model.areaBatchesOfLayer.size(); ++layer) {
        const LayerRun batches = model.areaBatchesOfLayer[layer];
        draws[layer].firstInstance = batches.count > 0 ? model.areaBatches[batches.first].firstInstance : 0;
    }
    return draws;
}

/// A box around everything a step draws.
Box2 reachOf(const BoardModel& model, std::span<const shader::ShapeBound> bounds) {
    Box2 reach;
    for (const shader::Cluster& cluster : model.clusters) {
        reach.include(Box2{cluster.boxMin, cluster.boxMax});
    }
    for (const shader::AreaInstance& area : model.instances) {
        // However the area is rotated, its circle lies within this far of its origin.
        const shader::ShapeBound& bound = bounds[area.shape];
        const float radius = glm::length(bound.centre) + glm::length(bound.extent);
        reach.include(Box2{area.origin - radius, area.origin + radius});
    }
    return reach;
}

/// Appends the runs of a layer's area batches to `runs`.
LayerRun addRuns(const LayerRun& batches, std::vector<shader::AreaRun>& runs) {
    const auto first = static_cast<std::uint32_t>(runs.size());
    for (std::uint32_t done = 0; done < batches.count; done += shader::kMostAreaDraws) {
        runs.push_back({batches.first + done, std::min(shader::kMostAreaDraws, batches.count - done)});
    }
    return {first, static_cast<std::uint32_t>(runs.size()) - first};
}

/// Of the board and all its steps. Layers of flipped copies lie elsewhere: there nothing is said to be hidden.
std::vector<LayerInSubstrate> inSubstrate(const BoardModel& model) {
    std::vector<LayerInSubstrate> layers = model.inSubstrate;
    layers.resize(model.layers.size());
    for (const BoardModel& step : model.steps) {
        for (std::size_t i = 0; i < std::min(layers.size(), step.inSubstrate.size()); ++i) {
            const LayerInSubstrate& own = step.inSubstrate[i];
            layers[i].marginMm = std::min(layers[i].marginMm, own.marginMm);
            layers[i].isMilled = layers[i].isMilled || own.isMilled;
            layers[i].role = own.role == LayerInSubstrate::Role::Content ? layers[i].role : own.role;
        }
    }
    const bool hasFlipped = std::ranges::any_of(model.copies, &ModelCopy::isFlipped);
    return hasFlipped ? std::vector<LayerInSubstrate>(layers.size()) : layers;
}

GeometryBuffers loadGeometry(gpu::Device& device, const BoardModel& model, const SceneStep& step,
                             const std::vector<shader::ShapeBound>& bounds) {
    SceneLoader loader(device);
    GeometryBuffers b;
    b.lets = loader.load("lets", model.lets);
    b.clusters = loader.load("clusters", model.clusters);
    b.vertices = loader.load("vertices", model.vertices);
    b.next = loader.load("next", model.next);
    b.indices = loader.load("indices", model.indices);
    b.instances = loader.load("instances", model.instances);
    b.drawOfInstance = loader.load("drawOfInstance", drawOfInstance(model));
    b.bounds = loader.load("bounds", bounds);
    b.elementStates = loader.load("element states", plainStates(model.elementCount));
    b.areaDraws = loader.load("areaDraws", areaDraws(model));
    b.areaRuns = loader.load("areaRuns", step.areaRuns);
    b.patchDraws = loader.load("patchDraws", patchDraws(model, step.layers.size()));
    b.countOfAll = loader.load("count of all", std::vector{kMostCommands});
    b.topShadows = loader.load("shadows on top", model.shadows.top.cells);
    b.bottomShadows = loader.load("shadows on the bottom", model.shadows.bottom.cells);
    b.bytes = loader.bytes();
    return b;
}

GeometryBuffers loadGeometry(gpu::Device& device, const std::vector<ElementState>& states) {
    SceneLoader loader(device);
    GeometryBuffers b;
    b.elementStates = loader.load("element states", states);
    b.topShadows = loader.load("shadows on top", ShadowMap().cells);
    b.bottomShadows = loader.load("shadows on the bottom", ShadowMap().cells);
    b.bytes = loader.bytes();
    return b;
}

StandardBuffers loadParts(gpu::Device& device, const StandardModel& model, std::size_t layerCount) {
    SceneLoader loader(device);
    StandardBuffers buffers;
    buffers.partsOfLayer.resize(layerCount);
    std::vector<shader::StandardPartRecord> records;
    for (std::uint32_t i = 0; i < model.parts.size(); ++i) {
        const StandardPart& part = model.parts[i];
        LayerRun& run = buffers.partsOfLayer[part.layer];
        run = {run.count == 0 ? i : run.first, run.count + 1};
        buffers.vertices.push_back(loader.load("standard vertices", part.vertices));
        buffers.indices.push_back(loader.load("standard indices", part.indices));
        buffers.indexCounts.push_back(static_cast<std::uint32_t>(part.indices.size()));
        records.push_back({buffers.vertices.back().address(), part.layer, 0});
    }
    buffers.records = loader.load("standard parts", records);
    buffers.bytes = loader.bytes();
    return buffers;
}

std::vector<SceneStep> makeSteps(const BoardModel& board) {
    std::vector<SceneStep> steps;
    steps.emplace_back(board, board.layers.size());
    for (const BoardModel& step : board.steps) {
        steps.emplace_back(step, board.layers.size());
    }
    return steps;
}

std::vector<SceneStep> loadSteps(gpu::Device& device, const StandardModel& board) {
    std::vector<SceneStep> steps;
    steps.emplace_back(device, board, board.layers.size());
    for (const StandardModel& step : board.steps) {
        steps.emplace_back(device, step, board.layers.size());
    }
    return steps;
}

Buffer makeLists(gpu::Device& device, const std::vector<SceneStep>& steps, const std::vector<ModelCopy>& copies,
                 std::uint64_t most) {
    std::uint64_t all = 0;
    std::uint64_t largest = 0;
    for (const ModelCopy& copy : copies) {
        all += steps[copy.step].listBytes();
        largest = std::max(largest, steps[copy.step].listBytes());
    }
    return {device, {"draw lists", std::max(largest, std::min(all, most)), MemoryUse::Transient}};
}

/// The words of a list that differ.
ElementRun changeBetween(const std::vector<ElementState>& before, const std::vector<ElementState>& after) {
    const auto first = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
    if (first == before.size()) {
        return {};
    }
    std::size_t end = before.size();
    while (before[end - 1] == after[end - 1]) {
        --end;
    }
    constexpr std::size_t kWord = shader::kElementsPerWord;
    return {first / kWord * kWord, (end + kWord - 1) / kWord * kWord};
}

/// Around both.
ElementRun united(const ElementRun& a, const ElementRun& b) {
    return a.from == a.end ? b : b.from == b.end ? a : ElementRun{std::min(a.from, b.from), std::max(a.end, b.end)};
}

/// Hands out parts of a buffer one behind the other.
class Parts {
public:
    Parts(VkBuffer buffer, VkDeviceAddress address, std::uint64_t offset)
        : m_buffer(buffer), m_address(address), m_offset(offset) {}

    BufferPart take(std::uint64_t size) {
        const BufferPart part{m_buffer, m_offset, size, m_address + m_offset};
        m_offset += (size + kAlignment - 1) / kAlignment * kAlignment;
        return part;
    }
    [[nodiscard]] std::uint64_t end() const { return m_offset; }

private:
    static constexpr std::uint64_t kAlignment = 64;  // lists of different shaders do not share a cache line

    VkBuffer m_buffer;
    VkDeviceAddress m_address;
    std::uint64_t m_offset;
};

bool hasShadows(const BoardModel& board) {
    return !board.shadows.isEmpty() ||
           std::ranges::any_of(board.steps, [](const BoardModel& step) { return !step.shadows.isEmpty(); });
}

DrawLists takeLists(const SceneStep& step, Parts& parts) {
    constexpr std::uint64_t kWord = sizeof(std::uint32_t);
    const std::uint64_t batches = 1 + step.layers.size();
    DrawLists lists;
    lists.visibleClusters = parts.take((4 + std::uint64_t{step.clusterCount}) * kWord);
    lists.letSlots = parts.take(std::uint64_t{step.letCount} * kWord);
    lists.visibleLets = parts.take((step.letCount + batches * shader::kQuadGroup) * kWord);
    lists.letDraws = parts.take(batches * shader::kDrawCount * sizeof(shader::DrawIndexed));
    lists.areaCounts = parts.take(step.areaDrawCount * kWord);
    lists.visibleInstances = parts.take(step.instanceCount * kWord);
    lists.visiblePatches = parts.take(step.instanceCount * kWord);
    lists.patchDraws = parts.take(step.layers.size() * sizeof(shader::Draw));
    lists.commandCounts = parts.take(step.areaRuns.size() * kWord);
    lists.capDraws = parts.take(step.areaDrawCount * sizeof(shader::DrawIndexed));
    lists.wallDraws = parts.take(step.areaDrawCount * sizeof(shader::Draw));
    return lists;
}

}  // namespace

SceneStep::SceneStep(const BoardModel& model, std::size_t layerCount)
    : layers(layerCount),
      letCount(static_cast<std::uint32_t>(model.lets.size())),
      clusterCount(static_cast<std::uint32_t>(model.clusters.size())),
      instanceCount(static_cast<std::uint32_t>(model.instances.size())),
      areaDrawCount(static_cast<std::uint32_t>(model.areaBatches.size())),
      states(plainStates(model.elementCount)),
      topShadows(model.shadows.top),
      bottomShadows(model.shadows.bottom) {
    ASSERT(model.layers.size() <= layerCount);
    for (std::size_t i = 0; i < model.layers.size(); ++i) {
        layers[i] = {model.clustersOfLayer[i], addRuns(model.areaBatchesOfLayer[i], areaRuns)};
    }
}

void SceneStep::load(gpu::Device& device, const BoardModel& model) {
    const std::vector<shader::ShapeBound> bounds = boundsOf(model);
    reach = reachOf(model, bounds);
    geometry = loadGeometry(device, model, *this, bounds);
}

SceneStep::SceneStep(gpu::Device& device, const StandardModel& model, std::size_t layerCount)
    : layers(layerCount),
      states(plainStates(model.elementCount)),
      geometry(loadGeometry(device, states)),
      standard(loadParts(device, model, layerCount)) {}

std::uint64_t SceneStep::listBytes() const {
    Parts parts(VK_NULL_HANDLE, 0, 0);
    takeLists(*this, parts);
    return isEmpty() || standard ? 0 : parts.end();
}

DrawLists SceneStep::listsAt(const Buffer& buffer, std::uint64_t offset) const {
    Parts parts(buffer.handle(), buffer.address(), offset);
    return takeLists(*this, parts);
}

void SceneStep::setAddresses(shader::FrameData& data, const DrawLists& lists) const {
    data.clusterCount = clusterCount;
    data.instanceCount = instanceCount;
    data.lets = geometry.lets.address();
    data.clusters = geometry.clusters.address();
    data.vertices = geometry.vertices.address();
    data.next = geometry.next.address();
    data.instances = geometry.instances.address();
    data.areaDraws = geometry.areaDraws.address();
    data.areaRuns = geometry.areaRuns.address();
    data.drawOfInstance = geometry.drawOfInstance.address();
    data.bounds = geometry.bounds.address();
    data.elementStates = geometry.elementStates.address();
    data.visibleClusters = lists.visibleClusters.address;
    data.letSlots = lists.letSlots.address;
    data.visibleLets = lists.visibleLets.address;
    data.letDraws = lists.letDraws.address;
    data.areaCounts = lists.areaCounts.address;
    data.visibleInstances = lists.visibleInstances.address;
    data.visiblePatches = lists.visiblePatches.address;
    data.patchDraws = lists.patchDraws.address;
    data.commandCounts = lists.commandCounts.address;
    data.capDraws = lists.capDraws.address;
    data.wallDraws = lists.wallDraws.address;
    data.standardParts = standard ? standard->records.address() : 0;
}

void SceneStep::setShadows(shader::FrameData& data, bool isTop) const {
    const ShadowGrid& map = isTop ? topShadows : bottomShadows;
    const Buffer& cells = isTop ? geometry.topShadows : geometry.bottomShadows;
    data.shadows.cells = cells.address();
    data.shadows.origin = map.origin - glm::vec2(data.centre);
    data.shadows.cellsPerMm = 1.0F / map.cellMm;
    data.shadows.width = map.width;
    data.shadows.height = map.height;
}

BoardScene::Impl::Impl(gpu::Device& owner, const BoardModel& model)
    : device(&owner), layers(model), steps(makeSteps(model)), copies(model.copies) {
    layers.inSubstrate = inSubstrate(model);
    layers.hasShadows = hasShadows(model);
}

BoardScene::Impl::Impl(gpu::Device& owner, const StandardModel& model)
    : device(&owner),
      layers(model),
      steps(loadSteps(owner, model)),
      copies(model.copies),
      lists(makeLists(owner, steps, copies, 0)),
      isLoaded(true) {}

void BoardScene::Impl::load(const BoardModel& model, std::uint64_t mostListBytes) {
    try {
        steps.front().load(*device, model);
        for (std::size_t i = 0; i < model.steps.size(); ++i) {
            steps[i + 1].load(*device, model.steps[i]);
        }
        lists = makeLists(*device, steps, copies, mostListBytes);
        letTables = makeLetTables();
        letIndices = SceneLoader(*device).load("letIndices", letTables.indices);
        isLoaded = true;
    } catch (const gpu::OutOfMemory&) {
        for (SceneStep& step : steps) {
            step.geometry = {};
        }
        lists = {};
        throw;
    }
}

BoardScene::BoardScene(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
BoardScene::BoardScene(gpu::Device& device, const BoardModel& model, std::uint64_t mostListBytes)
    : m_impl(std::make_unique<Impl>(device, model)) {
    m_impl->load(model, mostListBytes);
}
BoardScene::BoardScene(gpu::Device& device, const StandardModel& model)
    : m_impl(std::make_unique<Impl>(device, model)) {}
BoardScene::~BoardScene() = default;
BoardScene::BoardScene(BoardScene&&) noexcept = default;
BoardScene& BoardScene::operator=(BoardScene&&) noexcept = default;

namespace {

constexpr std::uint64_t kManyLists = 128ULL << 20U;
constexpr std::uint64_t kFewLists = 4ULL << 20U;

/// Calls `load`, with what it throws and a lost device as errors.
template <class Load>
base::Status tryToLoad(gpu::Device& device, const Load& load) {
    const std::string& name = device.caps().name;
    try {
        load();
    } catch (const gpu::OutOfMemory& shortage) {
        device.waitIdle();  // frees what was made before
        return base::Error{base::ErrorCode::DeviceFailed, "The board does not fit in the memory of " + name +
                                                              ": there is no room for " + shortage.what + "."};
    }
    if (device.isLost()) {
        return base::Error{base::ErrorCode::DeviceFailed,
                           "The Vulkan device " + name + " was lost while the board was loaded."};
    }
    return base::Done{};
}

base::Status load(BoardScene::Impl& scene, const BoardModel& model) {
    const base::Status status = tryToLoad(*scene.device, [&] { scene.load(model, kManyLists); });
    if (status || scene.device->isLost()) {
        return status;
    }
    spdlog::warn("{} Trying with shorter lists of what is seen.", status.error().text);
    return tryToLoad(*scene.device, [&] { scene.load(model, kFewLists); });
}

}  // namespace

base::Result<BoardScene> BoardScene::make(gpu::Device& device, const BoardModel& model) {
    BoardScene scene(std::make_unique<Impl>(device, model));
    RETURN_IF_ERROR(render::load(*scene.m_impl, model));
    return scene;
}

base::Result<BoardScene> BoardScene::make(gpu::Device& device, const StandardModel& model) {
    std::unique_ptr<Impl> made;
    RETURN_IF_ERROR(tryToLoad(device, [&] { made = std::make_unique<Impl>(device, model); }));
    return BoardScene(std::move(made));
}

BoardScene BoardScene::makeUnloaded(gpu::Device& device, std::shared_ptr<const BoardModel> model) {
    BoardScene scene(std::make_unique<Impl>(device, *model));
    scene.m_impl->unloaded = std::move(model);
    return scene;
}

base::Status BoardScene::load() {
    if (!m_impl->isLoaded) {
        RETURN_IF_ERROR(render::load(*m_impl, *m_impl->unloaded));
        m_impl->unloaded.reset();
    }
    return base::Done{};
}

void BoardScene::setStyles(std::span<const LayerStyle> styles) {
    ASSERT(styles.size() == m_impl->layers.layers.size());
    m_impl->layers.styles.assign(styles.begin(), styles.end());
}

void BoardScene::setHeights(const BoardFrame& frame) {
    std::vector<FrameLayer>& layers = m_impl->layers.layers;
    ASSERT(frame.layers.size() == layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        layers[i].z0 = frame.layers[i].z0;
        layers[i].z1 = frame.layers[i].z1;
    }
    m_impl->layers.facesMm = frame.facesMm;
}

std::vector<ZRange> BoardScene::drawnHeights(const ViewSettings& settings) const {
    return render::drawnHeights(m_impl->layers, settings);
}

float BoardScene::drawnFaces(const ViewSettings& settings) const {
    return render::drawnFaces(m_impl->layers, settings);
}

void BoardScene::setStates(std::span<const ElementState> states, std::uint32_t step) {
    SceneStep& owner = m_impl->steps[step];
    // Those that nothing is said of are plain.
    std::vector<ElementState> wanted(states.begin(), states.end());
    wanted.resize(owner.states.size());
    owner.unsent = united(owner.unsent, changeBetween(owner.states, wanted));
    owner.states = std::move(wanted);
    owner.standingOut = static_cast<std::size_t>(std::ranges::count_if(owner.states, standsOut));
}

void BoardScene::Impl::sendStates(gpu::Frame& frame) {
    for (SceneStep& step : steps) {
        const ElementRun run = std::exchange(step.unsent, {});
        if (run.from == run.end) {
            continue;
        }
        gpu::memoryBarrier(frame.commands(), gpu::kAnything, gpu::kCopyWrite);
        const gpu::Frame::Slice staged = frame.put(std::span(step.states).subspan(run.from, run.end - run.from));
        const VkBufferCopy region{staged.offset, run.from * sizeof(ElementState), staged.bytes.size()};
        vkCmdCopyBuffer(frame.commands(), staged.buffer, step.geometry.elementStates.handle(), 1, &region);
        gpu::memoryBarrier(frame.commands(), gpu::kCopyWrite, gpu::kAnything);
    }
}

void BoardScene::Impl::resendStates() {
    for (SceneStep& step : steps) {
        step.unsent = {0, step.states.size()};
    }
}

void BoardScene::setPalette(std::span<const glm::vec3> colours) {
    ASSERT(colours.size() <= shader::kHighlightRow);
    m_impl->layers.palette = paletteOf(colours);
}

std::uint64_t BoardScene::geometryBytes() const {
    if (!m_impl->isLoaded) {
        return 0;
    }
    std::uint64_t bytes = m_impl->letIndices.size();
    for (const SceneStep& step : m_impl->steps) {
        bytes += step.geometry.bytes + (step.standard ? step.standard->bytes : 0);
    }
    return bytes;
}

std::uint64_t BoardScene::gpuBytes() const {
    return m_impl->isLoaded ? geometryBytes() + m_impl->lists.size() : 0;
}

}  // namespace render
