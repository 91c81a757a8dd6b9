#include "tests/gpu/gpu_fixture.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

namespace render::test {
namespace {

template <class T>
T orExit(base::Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().text.c_str());
        std::exit(1);
    }
    return std::move(*result);
}

}  // namespace

Gpu::Gpu(gpu::Instance madeInstance, gpu::Device madeDevice)
    : instance(std::move(madeInstance)), device(std::move(madeDevice)), presenter(device) {}

std::unique_ptr<Gpu>& Gpu::held() {
    static std::unique_ptr<Gpu> gpu;
    return gpu;
}

Gpu& Gpu::get() {
    if (held() == nullptr) {
        auto madeInstance = orExit(gpu::Instance::create({}));
        auto madeDevice = orExit(gpu::Device::create(madeInstance));
        held().reset(new Gpu(std::move(madeInstance), std::move(madeDevice)));
    }
    return *held();
}

void Gpu::close() {
    held().reset();
}

Scene::Scene(const SyntheticBoard& board) : model(board.build()), scene(Gpu::get().device, model) {
    scene.setStyles(board.styles());
    camera.fit(model.boxMin, model.boxMax, NamedView::Top, 4.0F / 3.0F);
}

Image Scene::draw(const ViewSettings& settings, std::uint32_t width, std::uint32_t height) {
    return orExit(Gpu::get().presenter.render(scene, camera, settings, width, height));
}

void Scene::lookDown(glm::vec2 min, glm::vec2 max) {
    camera.fitWindow(min, max, model.boxMax.z, (max.x - min.x) / (max.y - min.y));
}

std::vector<ElementState> statesOf(std::span<const model::ElementId> highlighted) {
    ElementStates states;
    states.add(highlighted, kHighlighted);
    return {states.bytes().begin(), states.bytes().end()};
}

Rgb pixel(const Image& image, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = (std::size_t{y} * image.width + x) * 4;
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

std::string describe(const Rgb& colour) {
    return std::to_string(colour.r) + "," + std::to_string(colour.g) + "," + std::to_string(colour.b);
}

int distance(const Rgb& a, const Rgb& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace render::test
