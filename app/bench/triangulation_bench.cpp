#include "app/bench/triangulation_bench.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "app/bench/triangulation_run.h"
#include "app/common/commit.h"
#include "app/common/console_progress.h"
#include "app/common/headless_device.h"
#include "render/modelling/area_meshes.h"

namespace app {

namespace bench = tri::bench;

namespace {

/// The areas of a board as polygons that can be triangulated: after the repair of those that cross themselves.
base::Result<bench::Set> boardSet(const std::string& path, const model::ReadOptions& reading) {
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const auto document, model::readBoard(path, reading, console.progress()));
    std::vector<render::ShapeMesh> meshes;
    for (const model::ShapeId shape : render::shapesInUse(*document)) {
        meshes.emplace_back().polygons = model::discretise(document->shapes, shape, {});
    }
    render::triangulateShapes(meshes, {}, console.progress());
    bench::Set set{std::filesystem::path(path).stem().string(), {}};
    for (const render::ShapeMesh& mesh : meshes) {
        render::forEachPolygon(mesh.polygons, [&](std::uint32_t, const tri::Polygon& polygon) {
            if (!mesh.failed && !polygon.points.empty()) {
                set.shapes.push_back({{polygon.points.begin(), polygon.points.end()},
                                      {polygon.loopStart.begin(), polygon.loopStart.end()}});
            }
        });
    }
    return set;
}

bool isWanted(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Errors: BadUsage for a name that no set has.
base::Status checkNames(const std::vector<std::string>& names, const std::vector<bench::Set>& sets) {
    for (const std::string& name : names) {
        if (name != "none" && std::ranges::find(sets, name, &bench::Set::name) == sets.end()) {
            std::string known = "none";
            for (const bench::Set& set : sets) {
                known += ", " + set.name;
            }
            return base::Error{base::ErrorCode::BadUsage, "--sets: there is no set " + name + "; there are " + known};
        }
    }
    return base::Done{};
}

base::Result<std::vector<bench::Set>> collectSets(const TriangulationBenchArguments& arguments) {
    std::vector<bench::Set> generated = bench::standardSets(arguments.withHuge);
    RETURN_IF_ERROR(checkNames(arguments.sets, generated));
    std::vector<bench::Set> sets;
    for (const std::string& path : arguments.boards) {
        ASSIGN_OR_RETURN(bench::Set set, boardSet(path, arguments.reading));
        sets.push_back(std::move(set));
    }
    for (bench::Set& set : generated) {
        if (isWanted(arguments.sets, set.name)) {
            sets.push_back(std::move(set));
        }
    }
    return sets;
}

bench::Options optionsFor(const TriangulationBenchArguments& arguments, std::optional<DeviceTriangulator>& device) {
    bench::Options options;
    options.repeats = arguments.repeats;
    options.threads = arguments.threads;
    for (int& threads : options.threads) {
        threads = threads == 0 ? static_cast<int>(std::thread::hardware_concurrency()) : threads;
    }
    options.threads.erase(std::unique(options.threads.begin(), options.threads.end()), options.threads.end());
    options.triangulators.clear();
    for (const tri::Triangulator each :
         {tri::Triangulator::Cgal, tri::Triangulator::Cpu, tri::Triangulator::Parallel}) {
        if (isWanted(arguments.triangulators, std::string(tri::nameOf(each)))) {
            options.triangulators.push_back(each);
        }
    }
    if (device) {
        options.triangulators.push_back(tri::Triangulator::Gpu);
        options.device = device->triangulator.get();
        if (arguments.hasStages) {
            options.device->timeStages();
        }
    }
    return options;
}

/// Opens a device if one is wanted. It has to be there if it was requested by name; a software device takes part only
/// then, because it measures nothing.
base::Status openDevice(const TriangulationBenchArguments& arguments, std::optional<DeviceTriangulator>& device) {
    if (!isWanted(arguments.triangulators, "gpu")) {
        return base::Done{};
    }
    base::Result<DeviceTriangulator> opened = DeviceTriangulator::open();
    if (opened && (!arguments.triangulators.empty() || !opened->caps().isCpu)) {
        device.emplace(std::move(*opened));
    } else if (!opened && !arguments.triangulators.empty()) {
        return opened.error();
    }
    return base::Done{};
}

/// The processor, its cores and the Vulkan device, as far as the machine reports it.
std::string describeMachine(const std::optional<DeviceTriangulator>& device) {
    std::string processor = "unknown processor";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            processor = line.substr(std::min(line.size(), line.find(':') + 2));
            break;
        }
    }
    processor += ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
    return device ? processor + "; " + device->caps().name : processor;
}

}  // namespace

Outcome runTriangulationBench(const TriangulationBenchArguments& arguments) {
    std::optional<DeviceTriangulator> device;
    RETURN_IF_ERROR(openDevice(arguments, device));
    ASSIGN_OR_RETURN(const std::vector<bench::Set> sets, collectSets(arguments));
    const bench::Options options = optionsFor(arguments, device);
    std::vector<bench::SetReport> reports;
    for (const bench::Set& set : sets) {
        std::fprintf(stderr, "measuring %s\n", set.name.c_str());
        reports.push_back(bench::measure(set, options));
    }
    const std::string text =
        arguments.asJson ? bench::toJson(reports, describeMachine(device), kCommit) : bench::toTable(reports);
    std::fputs(text.c_str(), stdout);
    if (bench::isAllEqual(reports)) {
        return int{kDone};
    }
    return base::Error{base::ErrorCode::OutputFailed, "the triangulators disagree, or the verifier found a fault"};
}

}  // namespace app
