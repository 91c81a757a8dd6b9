// How long the flat picture of a board takes from tiles: flat_bench BOARD [WIDTH HEIGHT]. Milliseconds, and how many
// pixels differ from the picture that the device draws.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

#include "model/base/stopwatch.h"
#include "model/formats/registry.h"
#include "render/scene/scene_buffers.h"
#include "render/tiles/flat_picture.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

namespace {

Image imageOf(std::span<const std::uint32_t> pixels, int width, int height) {
    Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
    for (const std::uint32_t pixel : pixels) {
        for (const std::uint32_t shift : {16U, 8U, 0U, 24U}) {
            image.rgba.push_back(static_cast<std::uint8_t>(pixel >> shift));
        }
    }
    return image;
}

/// A board in both pipelines.
struct Bench {
    int width;
    int height;
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const BoardModel> board;
    BoardScene scene;
    FlatPicture flat;
    Camera camera;
    ViewSettings settings;
    std::vector<std::vector<ElementState>> states;

    void time(const char* what, double budgetMs, bool isCompared) {
        const base::Stopwatch watch;
        const FlatPicture::Quality quality =
            flat.draw({&scene.impl().layers, states, camera, settings, width, height}, budgetMs);
        const double ms = watch.milliseconds();
        std::printf("%-22s %7.1f ms  quality %d  %5.1f MB", what, ms, static_cast<int>(quality),
                    static_cast<double>(flat.bytes()) / 1e6);
        if (isCompared) {
            const Image device = *Gpu::get().presenter.render(
                scene, camera, settings, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
            const Image own = imageOf(*flat.pixels(), width, height);
            std::printf("  differ by more than 1: %zu, 8: %zu (device %.1f ms)", differingPixels(device, own, 1),
                        differingPixels(device, own, 8), Gpu::get().presenter.stats().gpuMs);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
    void highlight(model::NetId net) {
        states = {statesOf(document->elementsOf(net))};
        scene.setStates(states.front());
        settings.dim = kDimRest;
    }
};

}  // namespace

int main(int argc, char** argv) {
    base::Progress progress;
    auto document = *model::readBoard(argv[1], {}, progress);
    auto board = std::make_shared<const BoardModel>(*buildBoardModel(*document, {}, progress));
    const int width = argc > 3 ? std::stoi(argv[2]) : 1920;
    const int height = argc > 3 ? std::stoi(argv[3]) : 1080;
    const base::Stopwatch watch;
    Bench bench{width, height, document, board, BoardScene(Gpu::get().device, *board), FlatPicture(board), {}, {}, {}};
    std::printf("made in %.1f ms\n", watch.milliseconds());
    bench.settings.is2d = true;
    std::vector<LayerStyle> styles = defaultStyles(*document, Appearance::Flat);
    bench.scene.setStyles(styles);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    bench.camera.setOrthographic(true);
    bench.camera.fit(board->boxMin, board->boxMax, NamedView::Top, aspect);
    bench.time("first, rough", 8.0, false);
    bench.time("all tiles", 0.0, true);
    bench.time("nothing new", 8.0, false);
    for (int i = 0; i < 6; ++i) {
        bench.camera.pan({60.0F, 35.0F}, static_cast<float>(height));
        bench.time("pan", 8.0, false);
    }
    bench.time("pan, at rest", 0.0, true);
    for (int i = 0; i < 4; ++i) {
        bench.camera.zoom(1.2F, {0.2F, 0.1F}, aspect);
        bench.time("zoom", 1e-6, false);
    }
    bench.time("zoom, at rest", 0.0, true);
    bench.camera.zoom(8.0F, {0.2F, 0.1F}, aspect);
    bench.time("8x nearer", 0.0, true);
    bench.camera.fit(board->boxMin, board->boxMax, NamedView::Top, aspect);
    bench.time("whole again", 0.0, false);
    for (std::size_t net = 0; net < std::min<std::size_t>(4, document->nets.size()); ++net) {
        bench.highlight(model::NetId{net * 37 % document->nets.size()});
        bench.time("highlight", 0.0, true);
    }
    std::vector<model::NetId> nets;
    for (std::size_t row = 0; row < document->nets.size(); ++row) {
        nets.emplace_back(row);
    }
    std::ranges::stable_sort(nets, std::greater(), [&](model::NetId net) { return document->elementsOf(net).size(); });
    nets.resize(std::min<std::size_t>(8, nets.size()));
    for (const model::NetId net : nets) {
        bench.highlight(net);
        bench.time("large net", 0.0, true);
        bench.settings.dim = 0.0F;
        bench.time("the same, not dimmed", 0.0, true);
    }
    for (std::size_t i = 0; i < 3 && i < styles.size(); ++i) {
        styles[i].isVisible = !styles[i].isVisible;
        bench.scene.setStyles(styles);
        bench.time("layer", 0.0, i == 0);
    }
    return 0;
}
