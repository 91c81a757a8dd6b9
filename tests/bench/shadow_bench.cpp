// What shadows of bodies add to a frame: shadow_bench BOARD... Frames with and without them take turns, on the device
// that Copperscope takes, 1920 x 1080, smoothed as in the window. Prints medians, in ms of the processor time of all
// threads, which other programs on the machine change less than the clock, and their ratio; and how long the maps took.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "app/common/board_styles.h"
#include "app/common/headless_device.h"
#include "app/common/open_board.h"
#include "model/base/stopwatch.h"
#include "render/frame/offscreen_presenter.h"
#include "render/scene/scene_buffers.h"

namespace {

constexpr int kRepeats = 9;
constexpr std::uint32_t kWidth = 1920;
constexpr std::uint32_t kHeight = 1080;

double cpuMs() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Board {
    std::shared_ptr<const model::Document> document;
    render::BoardModel model;
};

base::Result<Board> openBoard(const char* path) {
    base::Progress progress;
    app::BoardArguments arguments;
    arguments.request.path = path;
    ASSIGN_OR_RETURN(const auto document, app::openDocument(arguments, progress));
    ASSIGN_OR_RETURN(render::BoardModel model, app::modelBoard(*document, arguments, progress));
    return Board{document, std::move(model)};
}

class Bench {
public:
    Bench(render::gpu::Device& device, const Board& board)
        : m_board(board), m_scene(device, board.model), m_presenter(device) {
        std::vector<render::LayerStyle> styles = render::defaultStyles(*board.document);
        app::showComponents(*board.document, styles);
        m_scene.setStyles(styles);
    }

    /// The model is cut into pieces by now, which adds a little.
    void measureMaps() const {
        std::vector<double> times;
        for (int i = 0; i < kRepeats; ++i) {
            const base::Stopwatch watch;
            const render::BodyShadows shadows = render::castShadows(m_board.model);
            times.push_back(watch.milliseconds());
        }
        const render::BodyShadows& shadows = m_board.model.shadows;
        std::printf("  %zu bodies, maps of %ux%u and %ux%u cells: %.1f ms\n", m_board.document->bodies.size(),
                    shadows.top.width, shadows.top.height, shadows.bottom.width, shadows.bottom.height,
                    medianOf(times));
    }

    void measure(render::Backend backend, float zoom) {
        std::vector<double> times[2];
        for (int i = 0; i < 2 * kRepeats + 2; ++i) {
            const bool hasShadows = i % 2 == 1;
            m_scene.impl().layers.hasShadows = hasShadows;
            const double ms = frame(backend, zoom);
            if (i >= 2) {
                times[hasShadows ? 1 : 0].push_back(ms);
            }
        }
        const double without = medianOf(times[0]);
        const double with = medianOf(times[1]);
        std::printf("  %-9s %3.0fx %8.1f %8.1f %6.3f\n", nameOf(m_presenter.stats().backend), zoom, without, with,
                    with / without);
        std::fflush(stdout);
    }

private:
    double frame(render::Backend backend, float zoom) {
        constexpr float kAspect = float(kWidth) / kHeight;
        render::Camera camera;
        camera.fit(m_board.model.boxMin, m_board.model.boxMax, render::NamedView::Iso, kAspect);
        camera.focusOnHeight(m_board.model.boxMax.z);
        camera.zoom(zoom, {0.0F, 0.0F}, kAspect);
        render::ViewSettings settings;
        settings.backend = backend;
        settings.isFabricated = true;
        const double start = cpuMs();
        const auto image = m_presenter.render(m_scene, camera, settings, kWidth, kHeight);
        return image ? cpuMs() - start : 0.0;
    }

    const Board& m_board;
    render::BoardScene m_scene;
    render::OffscreenPresenter m_presenter;
};

}  // namespace

int main(int argc, char** argv) {
    auto opened = app::HeadlessDevice::open();
    for (int i = 1; opened && i < argc; ++i) {
        const auto board = openBoard(argv[i]);
        if (!board) {
            std::fprintf(stderr, "%s\n", board.error().text.c_str());
            return 1;
        }
        std::printf("%s: view, ms without, with shadows, ratio\n", argv[i]);
        Bench bench(*opened->device, *board);
        bench.measureMaps();
        for (const render::Backend backend :
             {render::Backend::Pull, render::Backend::Mesh, render::Backend::Impostor, render::Backend::Raster}) {
            for (const float zoom : {1.0F, 5.0F, 30.0F}) {
                bench.measure(backend, zoom);
            }
        }
    }
    return opened ? 0 : 1;
}
