#include "render/calibration/calibrate.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

#include "model/base/median.h"
#include "model/base/stopwatch.h"
#include "render/backends/backend_choice.h"
#include "render/calibration/trial_board.h"
#include "render/frame/offscreen_presenter.h"
#include "render/gpu/check.h"
#include "render/gpu/device.h"

namespace render {
namespace {

/// Medians of the same back end differ by a few percent from one run to the next.
constexpr double kWorthwhile = 0.85;
constexpr float kZooms[] = {1.0F, 5.0F};  ///< by view
constexpr std::size_t kViews = std::size(kZooms);

ViewSettings settingsFor(Backend backend, bool isSmoothed) {
    ViewSettings settings;
    settings.backend = backend;
    settings.isSmoothed = isSmoothed;
    return settings;
}

/// A board on a device, drawn with one back end after the other.
class Measurement {
public:
    Measurement(gpu::Device& device, const Trial& trial, const BoardModel& model, BoardScene& scene,
                base::Progress& progress)
        : m_device(device), m_trial(trial), m_scene(scene), m_presenter(device), m_progress(progress) {
        const float aspect = static_cast<float>(trial.width) / static_cast<float>(trial.height);
        std::ranges::transform(kZooms, m_cameras.begin(),
                               [&](float zoom) { return tiltedCamera(model, zoom, aspect); });
    }

    /// Returns what Auto is to take.
    base::Result<Backend> measure(bool isSmoothed, std::vector<CandidateTime>& out) {
        const std::vector<Backend> candidates = tiltedBackends(m_device.caps(), isSmoothed);
        RETURN_IF_ERROR(warmUp(candidates, isSmoothed));
        std::vector<Times> times(candidates.size());
        for (int round = 0; round < m_trial.rounds; ++round) {
            m_progress.setFraction(static_cast<float>(round) / static_cast<float>(m_trial.rounds));
            for (std::size_t i = 0; i < candidates.size(); ++i) {
                RETURN_IF_ERROR(drawAll(candidates[i], isSmoothed, times[i]));
            }
        }
        std::vector<CandidateTime> medians;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            medians.push_back({candidates[i], isSmoothed, base::medianOf(times[i][0]) + base::medianOf(times[i][1])});
        }
        const Backend taken = fastestOf(medians, usual(isSmoothed));
        for (CandidateTime& each : medians) {
            each.isTaken = each.backend == taken;
        }
        out.insert(out.end(), medians.begin(), medians.end());
        return taken;
    }

private:
    using Times = std::array<std::vector<double>, kViews>;  ///< ms

    /// What the rules take for the whole board.
    [[nodiscard]] Backend usual(bool isSmoothed) const {
        const FramePlan plan = planFrame(m_scene.impl().layers, m_cameras[0], settingsFor(Backend::Auto, isSmoothed),
                                         m_trial.width, m_trial.height);
        return chooseBackend(Backend::Auto, m_device.caps(), plan, isSmoothed).backend;
    }

    /// The first frame of a back end compiles its pipelines.
    base::Status warmUp(const std::vector<Backend>& candidates, bool isSmoothed) {
        const double leastMs = m_device.caps().isCpu ? 0.0 : m_trial.warmUpMs;
        const base::Stopwatch watch;
        do {
            for (const Backend candidate : candidates) {
                Times unused;
                RETURN_IF_ERROR(drawAll(candidate, isSmoothed, unused));
            }
        } while (watch.milliseconds() < leastMs);
        return base::Done{};
    }

    base::Status drawAll(Backend backend, bool isSmoothed, Times& times) {
        for (std::size_t view = 0; view < kViews; ++view) {
            ASSIGN_OR_RETURN(const double ms, draw(backend, isSmoothed, m_cameras[view]));
            times[view].push_back(ms);
        }
        return base::Done{};
    }

    base::Result<double> draw(Backend backend, bool isSmoothed, const Camera& camera) {
        if (m_progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "cancelled"};
        }
        const base::Stopwatch watch;
        ASSIGN_OR_RETURN(
            [[maybe_unused]] const Image image,
            m_presenter.render(m_scene, camera, settingsFor(backend, isSmoothed), m_trial.width, m_trial.height));
        const double gpuMs = m_presenter.stats().gpuMs;
        return gpuMs > 0.0 ? gpuMs : watch.milliseconds();
    }

    gpu::Device& m_device;
    const Trial& m_trial;
    BoardScene& m_scene;
    OffscreenPresenter m_presenter;
    base::Progress& m_progress;
    std::array<Camera, kViews> m_cameras;
};

base::Result<Calibration> calibrateOwnDevice(const gpu::PipelineCacheOwner& owner, const Trial& trial,
                                             base::Progress& progress) {
    ASSIGN_OR_RETURN(const gpu::Instance instance, gpu::Instance::create({}));
    ASSIGN_OR_RETURN(gpu::Device device, gpu::Device::create(instance));
    if (device.caps().cacheOwner != owner) {
        return Calibration{};  // without a surface another device comes first
    }
    return calibrate(device, trial, progress);
}

}  // namespace

Camera tiltedCamera(const BoardFrame& board, float zoom, float aspect) {
    Camera camera;
    camera.fit(board.boxMin, board.boxMax, NamedView::Iso, aspect);
    camera.focusOnHeight(board.boxMax.z);
    camera.zoom(zoom, {0.0F, 0.0F}, aspect);
    return camera;
}

Backend fastestOf(std::span<const CandidateTime> times, Backend usual) {
    const auto fastest = std::ranges::min_element(times, {}, &CandidateTime::ms);
    const auto ruled = std::ranges::find(times, usual, &CandidateTime::backend);
    ASSERT(ruled != times.end());
    return fastest->ms <= kWorthwhile * ruled->ms ? fastest->backend : usual;
}

base::Result<Calibration> calibrate(gpu::Device& device, const Trial& trial, base::Progress& progress) {
    try {
        ASSIGN_OR_RETURN(const TrialBoard board, makeTrialBoard(trial.board, progress));
        ASSIGN_OR_RETURN(BoardScene scene, BoardScene::make(device, board.model));
        scene.setStyles(board.styles);
        Measurement measurement(device, trial, board.model, scene, progress);
        Calibration out;
        progress.beginPhase("Measuring back ends");
        ASSIGN_OR_RETURN(out.fastest.plain, measurement.measure(false, out.times));
        if (device.caps().canSmooth) {
            progress.beginPhase("Measuring back ends, smoothed");
            ASSIGN_OR_RETURN(out.fastest.smoothed, measurement.measure(true, out.times));
        }
        return out;
    } catch (const gpu::OutOfMemory& shortage) {
        return base::Error{base::ErrorCode::DeviceFailed, "There is no room for " + shortage.what + "."};
    }
}

base::Status calibrateOnce(const MeasuredBackendsFile& file, const gpu::PipelineCacheOwner& owner, const Trial& trial,
                           base::Progress& progress) {
    if (file.load()) {
        return base::Done{};
    }
    RETURN_IF_ERROR(file.save({}));
    const base::Result<Calibration> measured = calibrateOwnDevice(owner, trial, progress);
    if (measured) {
        spdlog::debug("Fastest back ends: {}, smoothed {}", nameOf(measured->fastest.plain),
                      nameOf(measured->fastest.smoothed));
        return file.save(measured->fastest);
    }
    spdlog::debug("Back ends were not measured: {}", measured.error().text);
    if (measured.error().code == base::ErrorCode::Cancelled) {
        file.remove();
    }
    return measured.error();
}

}  // namespace render
