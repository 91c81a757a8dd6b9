#include <algorithm>
#include <cmath>

#include "render/scene_buffers.h"
#include "render/scene_loader.h"

namespace render {
namespace {

using gpu::Buffer;
using gpu::MemoryUse;

/// The smallest circle around the box of a shape's vertices.
shader::ShapeBound boundOf(const BoardModel& model, const shader::ShapeRecord& shape) {
    glm::vec2 low(1e30F);
    glm::vec2 high(-1e30F);
    for (std::uint32_t i = shape.firstVertex; i < shape.firstVertex + shape.vertexCount; ++i) {
        low = glm::min(low, model.vertices[i]);
        high = glm::max(high, model.vertices[i]);
    }
    if (shape.vertexCount == 0) {
        return {};
    }
    return {0.5F * (low + high), 0.5F * glm::length(high - low), 0};
}

std::vector<shader::ShapeBound> boundsOf(const BoardModel& model) {
    std::vector<shader::ShapeBound> bounds;
    std::transform(model.shapes.begin(), model.shapes.end(), std::back_inserter(bounds),
                   [&](const shader::ShapeRecord& shape) { return boundOf(model, shape); });
    return bounds;
}

std::vector<std::uint32_t> drawOfInstance(const BoardModel& model) {
    std::vector<std::uint32_t> draws(model.instances.size());
    for (std::uint32_t i = 0; i < model.areaBatches.size(); ++i) {
        const AreaBatch& batch = model.areaBatches[i];
        std::fill_n(draws.begin() + batch.firstInstance, batch.instanceCount, i);
    }
    return draws;
}

std::vector<shader::DrawIndexed> capDraws(const BoardModel& model) {
    std::vector<shader::DrawIndexed> draws;
    for (const AreaBatch& batch : model.areaBatches) {
        const shader::ShapeRecord& shape = model.shapes[batch.shape];
        draws.push_back({shape.triangleCount * 3, 0, shape.firstIndex, shape.firstVertex, batch.firstInstance});
    }
    return draws;
}

std::vector<shader::Draw> wallDraws(const BoardModel& model) {
    constexpr std::uint32_t kPerEdge = 6;
    std::vector<shader::Draw> draws;
    for (const AreaBatch& batch : model.areaBatches) {
        const shader::ShapeRecord& shape = model.shapes[batch.shape];
        draws.push_back({shape.vertexCount * kPerEdge, 0, shape.firstVertex * kPerEdge, batch.firstInstance});
    }
    return draws;
}

std::uint32_t elementCount(const BoardModel& model) {
    std::uint32_t count = 0;
    for (const shader::Let& let : model.lets) {
        count = std::max(count, let.element + 1);
    }
    for (const shader::AreaInstance& instance : model.instances) {
        count = std::max(count, instance.element + 1);
    }
    return count;
}

bool isTube(const shader::Let& let) {
    return (let.meta & shader::kLetKindMask) == shader::kLetStadium && let.p5 > 0.0F;
}

void countLets(const BoardModel& model, SceneLayers::Layer& layer) {
    for (std::uint32_t c = layer.clusters.first; c < layer.clusters.first + layer.clusters.count; ++c) {
        const shader::Cluster& cluster = model.clusters[c];
        for (std::uint32_t i = cluster.firstLet; i < cluster.firstLet + cluster.count; ++i) {
            ++(isTube(model.lets[i]) ? layer.tubes : layer.openLets);
        }
    }
}

SceneLayers layersOf(const BoardModel& model) {
    SceneLayers scene;
    const glm::vec3 size = model.boxMax - model.boxMin;
    scene.widthMm = std::max(size.x, size.y);
    for (std::size_t i = 0; i < model.layerBottomMm.size(); ++i) {
        SceneLayers::Layer layer;
        layer.z0 = model.layerBottomMm[i];
        layer.z1 = model.layerTopMm[i];
        layer.clusters = model.clustersOfLayer[i];
        layer.areaBatches = model.areaBatchesOfLayer[i];
        layer.hasAreas = layer.areaBatches.count > 0;
        countLets(model, layer);
        scene.layers.push_back(layer);
    }
    scene.styles.resize(scene.layers.size());
    return scene;
}

GeometryBuffers loadGeometry(gpu::Device& device, const BoardModel& model, const LetTables& tables,
                             std::uint32_t elementWords) {
    SceneLoader loader(device);
    GeometryBuffers b;
    b.lets = loader.load("lets", model.lets);
    b.clusters = loader.load("clusters", model.clusters);
    b.vertices = loader.load("vertices", model.vertices);
    b.next = loader.load("next", model.next);
    b.indices = loader.load("indices", model.indices);
    b.instances = loader.load("instances", model.instances);
    b.drawOfInstance = loader.load("drawOfInstance", drawOfInstance(model));
    b.bounds = loader.load("bounds", boundsOf(model));
    b.highlight = loader.load("highlight", std::vector<std::uint32_t>(elementWords));
    b.capDraws = loader.load("capDraws", capDraws(model));
    b.wallDraws = loader.load("wallDraws", wallDraws(model));
    b.letIndices = loader.load("letIndices", tables.indices);
    return b;
}

TransientBuffers makeTransient(gpu::Device& device, const BoardModel& model) {
    const auto make = [&](std::string_view label, std::uint64_t bytes) {
        return Buffer(device, {label, bytes, MemoryUse::Transient, false});
    };
    constexpr std::uint64_t kWord = sizeof(std::uint32_t);
    TransientBuffers b;
    b.visibleClusters = make("visibleClusters", (4 + model.clusters.size()) * kWord);
    // A let is in one of its topology's levels, and any may take all of them.
    b.visibleLets = make("visibleLets", model.lets.size() * shader::kLevelCount * kWord);
    const std::uint64_t batches = 1 + model.layerBottomMm.size();
    b.letDraws = make("letDraws", batches * shader::kBucketCount * sizeof(shader::DrawIndexed));
    b.visibleInstances = make("visibleInstances", model.instances.size() * kWord);
    b.capDraws = make("capDraws", model.areaBatches.size() * sizeof(shader::DrawIndexed));
    b.wallDraws = make("wallDraws", model.areaBatches.size() * sizeof(shader::Draw));
    return b;
}

}  // namespace

BoardScene::Impl::Impl(gpu::Device& owner, const BoardModel& model)
    : device(&owner),
      uploads(owner, 1, "scene updates"),
      layers(layersOf(model)),
      letTables(makeLetTables()),
      clusterCount(static_cast<std::uint32_t>(model.clusters.size())),
      instanceCount(static_cast<std::uint32_t>(model.instances.size())),
      areaDrawCount(static_cast<std::uint32_t>(model.areaBatches.size())),
      elementWords((elementCount(model) + 31) / 32),
      geometry(loadGeometry(owner, model, letTables, elementWords)),
      transient(makeTransient(owner, model)) {}

void BoardScene::Impl::setAddresses(shader::FrameData& data) const {
    data.clusterCount = clusterCount;
    data.instanceCount = instanceCount;
    data.lets = geometry.lets.address();
    data.clusters = geometry.clusters.address();
    data.vertices = geometry.vertices.address();
    data.next = geometry.next.address();
    data.instances = geometry.instances.address();
    data.drawOfInstance = geometry.drawOfInstance.address();
    data.bounds = geometry.bounds.address();
    data.highlight = geometry.highlight.address();
    data.visibleClusters = transient.visibleClusters.address();
    data.visibleLets = transient.visibleLets.address();
    data.letDraws = transient.letDraws.address();
    data.visibleInstances = transient.visibleInstances.address();
    data.capDraws = transient.capDraws.address();
    data.wallDraws = transient.wallDraws.address();
    data.standardParts = standard ? standard->records.address() : 0;
}

BoardScene::BoardScene(gpu::Device& device, const BoardModel& model) : m_impl(std::make_unique<Impl>(device, model)) {}
BoardScene::~BoardScene() = default;
BoardScene::BoardScene(BoardScene&&) noexcept = default;
BoardScene& BoardScene::operator=(BoardScene&&) noexcept = default;

void BoardScene::setStyles(std::span<const LayerStyle> styles) {
    ASSERT(styles.size() == m_impl->layers.layers.size());
    m_impl->layers.styles.assign(styles.begin(), styles.end());
}

void BoardScene::setHighlight(std::span<const model::ElementId> elements) {
    std::vector<std::uint32_t> words(m_impl->elementWords);
    for (const model::ElementId element : elements) {
        // Elements after the last one drawn have no bit: empty areas, say.
        if (element.row() / 32 < words.size()) {
            words[element.row() / 32] |= 1U << (element.row() % 32);
        }
    }
    gpu::upload(m_impl->uploads, m_impl->geometry.highlight, std::as_bytes(std::span(words)));
}

std::uint64_t BoardScene::gpuBytes() const {
    const GeometryBuffers& g = m_impl->geometry;
    const TransientBuffers& t = m_impl->transient;
    std::uint64_t bytes = m_impl->standard ? m_impl->standard->bytes() : 0;
    for (const Buffer* buffer :
         {&g.lets, &g.clusters, &g.vertices, &g.next, &g.indices, &g.instances, &g.drawOfInstance, &g.bounds,
          &g.highlight, &g.capDraws, &g.wallDraws, &g.letIndices, &t.visibleClusters, &t.visibleLets, &t.letDraws,
          &t.visibleInstances, &t.capDraws, &t.wallDraws}) {
        bytes += buffer->size();
    }
    return bytes;
}

}  // namespace render
