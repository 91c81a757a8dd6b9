#include <algorithm>

#include "render/scene/scene_buffers.h"
#include "render/scene/scene_loader.h"
#include "render/standard/standard_model.h"

namespace render {
namespace {

bool hasAreas(const StandardModel& model, std::size_t layer) {
    const auto hasSome = [layer](const StandardModel& step) {
        return layer < step.hasAreas.size() && step.hasAreas[layer];
    };
    return hasSome(model) || std::ranges::any_of(model.steps, hasSome);
}

SceneLayers layersOf(const StandardModel& model) {
    SceneLayers scene;
    scene.facesMm = model.facesMm;
    scene.hasFlipped = std::ranges::any_of(model.copies, &ModelCopy::isFlipped);
    const glm::vec3 size = model.boxMax - model.boxMin;
    scene.widthMm = std::max(size.x, size.y);
    for (std::size_t i = 0; i < model.layerBottomMm.size(); ++i) {
        SceneLayers::Layer layer;
        layer.z0 = model.layerBottomMm[i];
        layer.z1 = model.layerTopMm[i];
        layer.hasAreas = hasAreas(model, i);
        layer.opposite = i < model.opposite.size() ? model.opposite[i] : model::LayerId{};
        layer.isCopper = model.isCopper[i];
        layer.growth = model.layerGrowth[i];
        scene.layers.push_back(layer);
    }
    scene.styles.resize(scene.layers.size());
    return scene;
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
    return buffers;
}

}  // namespace

std::uint64_t StandardBuffers::bytes() const {
    std::uint64_t sum = records.size();
    for (const std::vector<gpu::Buffer>* column : {&vertices, &indices}) {
        for (const gpu::Buffer& buffer : *column) {
            sum += buffer.size();
        }
    }
    return sum;
}

SceneStep::SceneStep(gpu::Device& device, const StandardModel& model, std::size_t layerCount)
    : layers(layerCount), states(plainStates(model.elementCount)), standard(loadParts(device, model, layerCount)) {
    geometry.elementStates = SceneLoader(device).load("element states", states);
}

BoardScene::Impl::Impl(gpu::Device& owner, const StandardModel& model)
    : device(&owner), uploads(owner, 1, "scene updates"), layers(layersOf(model)), copies(model.copies) {
    steps.emplace_back(owner, model, layers.layers.size());
    for (const StandardModel& step : model.steps) {
        steps.emplace_back(owner, step, layers.layers.size());
    }
    lists = gpu::Buffer(owner, {"draw lists", steps.front().listBytes(), gpu::MemoryUse::Transient, false});
}

BoardScene::BoardScene(gpu::Device& device, const StandardModel& model)
    : m_impl(std::make_unique<Impl>(device, model)) {}

}  // namespace render
