#include "app/bench/calibration_bench.h"

#include <cstdio>

#include "app/common/commit.h"
#include "app/common/console_progress.h"
#include "app/common/headless_device.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"
#include "render/calibration/calibrate.h"

namespace app {
namespace {

/// `file`: where it was saved; empty: nowhere.
nlohmann::ordered_json toJson(const render::Calibration& calibration, const std::string& device,
                              const std::string& file) {
    nlohmann::ordered_json times = nlohmann::ordered_json::array();
    for (const render::CandidateTime& each : calibration.times) {
        times.push_back({{"backend", nameOf(each.backend)},
                         {"smoothed", each.isSmoothed},
                         {"ms", each.ms},
                         {"is_auto", each.isTaken}});
    }
    return {{"device", device}, {"commit", kCommit}, {"file", file}, {"times", times}};
}

std::string toTable(const render::Calibration& calibration, const std::string& device, const std::string& file) {
    std::string text = device + "; commit " + kCommit + "\n\nTilted views of t8, whole and 5x, 1280x800, median ms; " +
                       "* is what auto takes\nback end   smoothed        ms\n";
    for (const render::CandidateTime& each : calibration.times) {
        const std::string name = std::string(nameOf(each.backend)) + (each.isTaken ? " *" : "");
        text += model::formatted("%-10s %-8s %9.2f\n", name.c_str(), each.isSmoothed ? "yes" : "no", each.ms);
    }
    return file.empty() ? text : text + "\nSaved in " + file + "\n";
}

}  // namespace

Outcome runCalibrationBench(const CalibrationBenchArguments& arguments) {
    ASSIGN_OR_RETURN(HeadlessDevice opened, HeadlessDevice::open());
    const render::gpu::Caps& caps = opened.device->caps();
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const render::Calibration calibration, render::calibrate(*opened.device, {}, console.progress()));
    const render::MeasuredBackendsFile file(render::gpu::pipelineCacheFolder(), caps.cacheOwner);
    const base::Status saved = file.save(calibration.fastest);  // where that fails the times are still worth reading
    const std::string device = caps.name + ", " + caps.driver;
    const std::string path = saved ? file.path().string() : "";
    const std::string text =
        arguments.asJson ? model::jsonText(toJson(calibration, device, path)) : toTable(calibration, device, path);
    std::fputs(text.c_str(), stdout);
    RETURN_IF_ERROR(saved);
    return int{kDone};
}

}  // namespace app
