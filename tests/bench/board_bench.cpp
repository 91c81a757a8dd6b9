// board_bench BOARD...: from archive to first frame, and whether the back ends draw the same picture. Prints a table;
// gates nothing.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "model/reader.h"
#include "render/board_model.h"
#include "render/gpu/device.h"
#include "render/gpu/instance.h"
#include "render/view.h"

namespace {

constexpr std::uint32_t kWidth = 1920;
constexpr std::uint32_t kHeight = 1080;

class Stopwatch {
public:
    double lapMs() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - m_start).count();
        m_start = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Share of pixels that differ by more than 8 levels in some channel.
double differentPixels(const render::Image& a, const render::Image& b) {
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        int worst = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            worst = std::max(worst, std::abs(int{a.rgba[pixel + channel]} - int{b.rgba[pixel + channel]}));
        }
        count += worst > 8 ? 1 : 0;
    }
    return 4.0 * static_cast<double>(count) / static_cast<double>(a.rgba.size());
}

struct Frames {
    render::Image image;
    double firstMs = 0.0;
    double medianMs = 0.0;
};

base::Result<Frames> drawSeveral(render::gpu::Device& device, render::BoardScene& scene, const render::Camera& camera,
                                 render::Backend backend, int count) {
    render::OffscreenPresenter presenter(device);
    render::ViewSettings settings;
    settings.backend = backend;
    settings.isSmoothed = false;
    Frames frames;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
        Stopwatch watch;
        base::Result<render::Image> image = presenter.render(scene, camera, settings, kWidth, kHeight);
        if (!image) {
            return image.error();
        }
        times.push_back(watch.lapMs());
        frames.image = std::move(*image);
    }
    frames.firstMs = times.front();
    std::ranges::sort(times);
    frames.medianMs = times[times.size() / 2];
    return frames;
}

bool bench(render::gpu::Device& device, const char* path) {
    base::Progress progress;
    Stopwatch watch;
    const auto document = model::readBoard(path, {}, progress);
    if (!document) {
        std::fprintf(stderr, "%s\n", document.error().text.c_str());
        return false;
    }
    const double readMs = watch.lapMs();
    const auto model = render::buildBoardModel(**document, {}, progress);
    const double modelMs = watch.lapMs();
    render::BoardScene scene(device, *model);
    scene.setStyles(render::defaultStyles(**document));
    const double uploadMs = watch.lapMs();
    render::Camera camera;
    camera.fit(model->boxMin, model->boxMax, render::NamedView::Iso, static_cast<float>(kWidth) / kHeight);
    const auto pull = drawSeveral(device, scene, camera, render::Backend::Pull, 5);
    const auto mesh = device.caps().hasMeshShader ? drawSeveral(device, scene, camera, render::Backend::Mesh, 2)
                                                  : base::Result<Frames>(Frames{});
    if (!pull || !mesh) {
        std::fprintf(stderr, "%s\n", (pull ? mesh : pull).error().text.c_str());
        return false;
    }
    const double difference = mesh->image.rgba.empty() ? 0.0 : differentPixels(pull->image, mesh->image);
    std::printf("%-36s %8zu %9zu %8.0f %8.0f %8.0f %8.0f %9.0f %8.1f %8.1f %9.4f\n",
                std::filesystem::path(path).filename().c_str(), model->lets.size(), model->indices.size() / 3, readMs,
                modelMs, uploadMs, pull->firstMs, readMs + modelMs + uploadMs + pull->firstMs, pull->medianMs,
                mesh->medianMs, 100.0 * difference);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const auto instance = render::gpu::Instance::create({});
    auto device =
        instance ? render::gpu::Device::create(*instance) : base::Result<render::gpu::Device>(instance.error());
    if (!device) {
        std::fprintf(stderr, "%s\n", device.error().text.c_str());
        return 3;
    }
    std::printf("%s, %ux%u, whole board; ms unless said\n", device->caps().name.c_str(), kWidth, kHeight);
    std::printf("%-36s %8s %9s %8s %8s %8s %8s %9s %8s %8s %9s\n", "board", "lets", "triangles", "read", "model",
                "upload", "1st", "sum", "pull", "mesh", "differ %");
    bool isGood = true;
    for (int i = 1; i < argc; ++i) {
        isGood = bench(*device, argv[i]) && isGood;
    }
    return isGood ? 0 : 2;
}
