#include "app/bench/bench_board.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include "app/common/board_styles.h"
#include "app/common/console_progress.h"
#include "model/base/stopwatch.h"
#include "render/backends/backend_choice.h"
#include "render/calibration/calibrate.h"
#include "render/frame/frame_measures.h"

namespace app {

namespace {

using render::Backend;

constexpr std::uint32_t kWidth = 1920;
constexpr std::uint32_t kHeight = 1080;
constexpr float kAspect = static_cast<float>(kWidth) / static_cast<float>(kHeight);
constexpr int kWarmUp = 2;           // frames
constexpr double kWarmUpMs = 300.0;  // until a card that was idle runs at full speed

struct View {
    const char* name;
    float zoom;
};
constexpr View kViews[] = {{"whole", 1.0F}, {"5x", 5.0F}, {"30x", 30.0F}};

render::ViewSettings settingsFor(Backend backend, render::LevelOfDetail levels, bool isCulled) {
    render::ViewSettings settings;
    settings.backend = backend;
    settings.levels = levels;
    settings.isSmoothed = false;
    settings.cull = isCulled;
    return settings;
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Draws frames of one scene; keeps the standard pipeline's pictures to compare with.
class FrameBench {
public:
    FrameBench(render::gpu::Device& device, const BenchArguments& arguments)
        : m_device(device),
          m_presenter(device),
          m_levels(levelsOf(arguments.levels)),
          m_onlyCulled(arguments.onlyCulled),
          m_hasComponents(arguments.hasComponents),
          m_frames(arguments.frames) {
        if (arguments.hasStages) {
            m_presenter.timeStages();
        }
    }

    [[nodiscard]] bool hasComponents() const { return m_hasComponents; }

    base::Status measure(render::BoardScene& scene, const render::BoardFrame& frame, bool isStandard,
                         std::vector<FrameResult>& out) {
        m_auto.clear();
        for (const View& view : kViews) {
            RETURN_IF_ERROR(isStandard ? measureOne(scene, frame, view, Backend::Auto, false, out)
                                       : measureAll(scene, frame, view, out));
        }
        return base::Done{};
    }

private:
    base::Status measureAll(render::BoardScene& scene, const render::BoardFrame& frame, const View& view,
                            std::vector<FrameResult>& out) {
        for (const Backend backend : render::tiltedBackends(m_device.caps(), false)) {
            for (const bool isCulled : {true, false}) {
                if (!isCulled && m_onlyCulled) {
                    continue;
                }
                RETURN_IF_ERROR(measureOne(scene, frame, view, backend, isCulled, out));
            }
        }
        return base::Done{};
    }

    base::Status warmUp(render::BoardScene& scene, const render::Camera& camera, const render::ViewSettings& settings) {
        const double leastMs = m_device.caps().isCpu ? 0.0 : kWarmUpMs;
        const base::Stopwatch watch;
        for (int i = 0; i < kWarmUp || watch.milliseconds() < leastMs; ++i) {
            const auto image = m_presenter.render(scene, camera, settings, kWidth, kHeight);
            if (!image) {
                return image.error();
            }
        }
        return base::Done{};
    }

    base::Status measureOne(render::BoardScene& scene, const render::BoardFrame& frame, const View& view,
                            Backend backend, bool isCulled, std::vector<FrameResult>& out) {
        const render::Camera camera = render::tiltedCamera(frame, view.zoom, kAspect);
        const render::ViewSettings settings = settingsFor(backend, m_levels, isCulled);
        std::vector<double> times;
        std::map<std::string, std::vector<double>> stages;
        render::Image picture;
        RETURN_IF_ERROR(warmUp(scene, camera, settings));
        for (int i = 0; i < m_frames; ++i) {
            const base::Stopwatch watch;
            ASSIGN_OR_RETURN(render::Image image, m_presenter.render(scene, camera, settings, kWidth, kHeight));
            const render::FrameStats stats = m_presenter.stats();
            times.push_back(stats.gpuMs > 0.0 ? stats.gpuMs : watch.milliseconds());
            for (const auto& [name, ms] : m_presenter.stages()) {
                stages[name].push_back(ms);
            }
            picture = std::move(image);
        }
        FrameResult result;
        result.view = view.name;
        result.backend = nameOf(m_presenter.stats().backend);
        result.isCulled = isCulled;
        result.ms = medianOf(times);
        for (const auto& [name, ms] : stages) {
            result.stageMs[name] = medianOf(ms);
        }
        const Backend drew = m_presenter.stats().backend;
        result.triangles = trianglesOf(scene, camera, settings, drew);
        result.isAuto = drew == autoBackend(scene, camera, view);
        compare(view, drew, std::move(picture), result);
        out.push_back(std::move(result));
        return base::Done{};
    }

    /// What Auto takes for a view; found once.
    Backend autoBackend(render::BoardScene& scene, const render::Camera& camera, const View& view) {
        const auto [location, isNew] = m_auto.try_emplace(view.name, Backend::Auto);
        if (isNew && m_presenter.render(scene, camera, settingsFor(Backend::Auto, m_levels, true), kWidth, kHeight)) {
            location->second = m_presenter.stats().backend;
        }
        return location->second;
    }

    void compare(const View& view, Backend drew, render::Image picture, FrameResult& result) {
        if (drew == Backend::Standard) {
            m_expected[view.name] = std::move(picture);
        } else if (const auto expected = m_expected.find(view.name); expected != m_expected.end()) {
            result.greyMse = render::greyMse(picture, expected->second);
        }
    }

    /// Counted by the pull back end's culling, whose choices all back ends share.
    std::uint64_t trianglesOf(render::BoardScene& scene, const render::Camera& camera, render::ViewSettings settings,
                              Backend drew) {
        settings.backend = Backend::Pull;
        const bool isCounted = drew == Backend::Pull || drew == Backend::Standard ||
                               m_presenter.render(scene, camera, settings, kWidth, kHeight).ok();
        return isCounted ? render::drawnTriangles(scene, camera, settings, kWidth, kHeight).value_or(0) : 0;
    }

    render::gpu::Device& m_device;
    render::OffscreenPresenter m_presenter;
    render::LevelOfDetail m_levels;
    bool m_onlyCulled;
    bool m_hasComponents;
    int m_frames;
    std::map<std::string, render::Image> m_expected;
    std::map<std::string, Backend> m_auto;
};

/// Uploads a model and draws it.
template <class Model>
base::Status benchModel(render::gpu::Device& device, const model::Document& document, const Model& model,
                        std::uint64_t storedTriangles, FrameBench& frames, PipelineResult& out) {
    out.parseMs = document.times.parseMs + document.times.createMs;
    out.createMs = model.times.createMs;
    out.discretiseMs = model.times.discretiseMs;
    out.triangulateMs = model.times.triangulateMs;
    out.cpuBytes = render::cpuBytes(model);
    out.triangles = storedTriangles;
    device.waitIdle();  // what the pipeline before held is released by now
    const base::Stopwatch upload;
    ASSIGN_OR_RETURN(render::BoardScene made, render::BoardScene::make(device, model));
    render::BoardScene& scene = made;
    device.waitIdle();
    out.uploadMs = upload.milliseconds();
    out.gpuBytes = scene.gpuBytes();
    std::vector<render::LayerStyle> styles = render::defaultStyles(document);
    if (frames.hasComponents()) {
        showComponents(document, styles);
    }
    scene.setStyles(styles);
    return frames.measure(scene, model, out.name == "standard", out.frames);
}

/// The standard pipeline first: its pictures are what the others are compared with.
base::Status benchPipelines(render::gpu::Device& device, const model::Document& document,
                            const BenchArguments& arguments, BoardResult& out) {
    ConsoleProgress console;
    const model::Discretisation how = discretisationOf(arguments.modelling);
    FrameBench frames(device, arguments);
    if (arguments.pipeline != "hybrid") {
        ASSIGN_OR_RETURN(const auto model, render::buildStandardModel(document, how, console.progress()));
        out.pipelines.emplace_back().name = "standard";
        RETURN_IF_ERROR(benchModel(device, document, model, model.triangles(), frames, out.pipelines.back()));
    }
    if (arguments.pipeline != "standard") {
        ASSIGN_OR_RETURN(const auto model, render::buildBoardModel(document, how, console.progress()));
        out.pipelines.emplace_back().name = "hybrid";
        RETURN_IF_ERROR(benchModel(device, document, model, model.indices.size() / 3, frames, out.pipelines.back()));
    }
    return base::Done{};
}

base::Result<std::shared_ptr<const model::Document>> read(const std::string& path, const BenchArguments& arguments) {
    ConsoleProgress console;
    BoardArguments board = arguments.modelling;
    board.request.path = path;
    return openDocument(board, console.progress());
}

}  // namespace

std::uint64_t BoardResult::elementCount() const {
    return std::accumulate(elements.begin(), elements.end(), std::uint64_t{0});
}

base::Result<BoardResult> benchBoard(render::gpu::Device& device, const std::string& path,
                                     const BenchArguments& arguments) {
    ASSIGN_OR_RETURN(const auto document, read(path, arguments));
    BoardResult out;
    out.name = std::filesystem::path(path).filename().string();
    std::ranges::copy(document->elementCounts(), out.elements.begin());
    RETURN_IF_ERROR(benchPipelines(device, *document, arguments, out));
    return out;
}

}  // namespace app
