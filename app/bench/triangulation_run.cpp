#include "app/bench/triangulation_run.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "model/base/parallel.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"
#include "tri/verify.h"

namespace tri::bench {

namespace {

using Triangles = std::vector<std::vector<std::uint32_t>>;

/// A line of /proc/self/status in bytes; 0 where there is none.
double statusBytes(const std::string& key) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with(key)) {
            return 1024.0 * std::stod(line.substr(key.size()));
        }
    }
    return 0.0;
}

double processCpuMs() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

std::vector<std::uint32_t> largestFirst(const Set& set) {
    return base::largestFirst(set.shapes.size(), [&](std::size_t i) { return set.shapes[i].points.size(); });
}

void triangulateOnDevice(const Set& set, gpu::Triangulator& device, Triangles& out) {
    std::vector<Polygon> polygons;
    std::ranges::transform(set.shapes, std::back_inserter(polygons), &Shape::polygon);
    base::Progress progress;
    std::vector<Triangulation> results = device.triangulate(polygons, progress);
    for (std::size_t i = 0; i < results.size(); ++i) {
        out[i] = std::move(results[i].triangles);
    }
}

void triangulateAll(const Set& set, const std::vector<std::uint32_t>& order, Triangulator triangulator,
                    gpu::Triangulator* device, Triangles& out) {
    out.assign(set.shapes.size(), {});
    if (triangulator == Triangulator::Gpu) {
        triangulateOnDevice(set, *device, out);
        return;
    }
    const auto one = [&](std::size_t rank) {
        const std::size_t i = order[rank];
        const Status status = triangulate(set.shapes[i].polygon(), triangulator, out[i]);
        if (status.outcome != Outcome::Ok) {
            out[i].clear();  // the verifier will say so
        }
    };
    if (triangulator == Triangulator::Parallel) {
        for (std::size_t rank = 0; rank < order.size(); ++rank) {
            one(rank);
        }
    } else {
        base::parallelFor(order.size(), one);
    }
}

/// In a thread of its own, whose working memory is fresh and gone afterwards.
double measureBytes(const Set& set, const std::vector<std::uint32_t>& order, Triangulator triangulator,
                    gpu::Triangulator* device) {
    if (triangulator == Triangulator::Gpu) {
        return 0.0;  // its memory is the device's: the tally knows
    }
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts anew
    const double before = statusBytes("VmRSS:");
    std::thread([&] {
        Triangles triangles;
        const base::ThreadLimit limit(1);
        triangulateAll(set, order, triangulator, device, triangles);
    }).join();
    return (statusBytes("VmHWM:") - before) / static_cast<double>(set.vertexCount());
}

std::uint64_t hashOf(const Triangles& triangles) {
    std::uint64_t hash = 0;
    for (const std::vector<std::uint32_t>& one : triangles) {
        hash = hash * 0x9E3779B97F4A7C15U + triangleSetHash(one);
    }
    return hash;
}

bool isAllRight(const Set& set, const Triangles& triangles) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (verify(set.shapes[i].polygon(), triangles[i]) != Fault::None) {
            return false;
        }
    }
    return true;
}

Run measureRun(const Set& set, Triangulator triangulator, int threads, const Options& options, Triangles& triangles) {
    const base::ThreadLimit limit(threads);
    const std::vector<std::uint32_t> order = largestFirst(set);
    Run run{triangulator, threads};
    for (int i = 0; i < options.repeats; ++i) {
        const double cpuStart = processCpuMs();
        const auto start = std::chrono::steady_clock::now();
        triangulateAll(set, order, triangulator, options.device, triangles);
        const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
        if (i == 0 || ms.count() < run.ms) {
            run.ms = ms.count();
            run.cpuMs = processCpuMs() - cpuStart;
            if (triangulator == Triangulator::Gpu) {
                run.deviceMs = options.device->tally().deviceMs;
                run.stageMs = options.device->tally().stageMs;
            }
        }
    }
    run.hash = hashOf(triangles);
    if (triangulator == Triangulator::Gpu) {
        const gpu::Tally& tally = options.device->tally();
        run.steps = tally.steps;
        run.onDevice = tally.onDevice;
        run.flagged = tally.flagged;
        run.bytesPerVertex = static_cast<double>(tally.deviceBytes) / static_cast<double>(set.vertexCount());
    }
    return run;
}

double verticesPerSecond(const SetReport& report, const Run& run) {
    return 1e3 * static_cast<double>(report.vertices) / run.ms;
}

}  // namespace

SetReport measure(const Set& set, const Options& options) {
    SetReport report{set.name, set.shapes.size(), set.vertexCount(), 0, {}};
    for (const Triangulator triangulator : options.triangulators) {
        const double bytes = measureBytes(set, largestFirst(set), triangulator, options.device);
        bool isVerified = false;
        const bool isOnDevice = triangulator == Triangulator::Gpu;
        for (const int threads : isOnDevice ? std::vector{options.threads.back()} : options.threads) {
            Triangles triangles;
            Run run = measureRun(set, triangulator, threads, options, triangles);
            run.bytesPerVertex += bytes;
            // Equal hashes are equal triangles: verify once per triangulator.
            const bool isKnown = isVerified && run.hash == report.runs.back().hash;
            isVerified = isKnown || isAllRight(set, triangles);
            run.isVerified = isVerified;
            report.runs.push_back(run);
            report.triangles = std::accumulate(triangles.begin(), triangles.end(), std::size_t{0},
                                               [](std::size_t sum, const auto& one) { return sum + one.size() / 3; });
        }
    }
    return report;
}

bool isAllEqual(const std::vector<SetReport>& reports) {
    return std::ranges::all_of(reports, [](const SetReport& report) {
        return std::ranges::all_of(
            report.runs, [&](const Run& run) { return run.isVerified && run.hash == report.runs.front().hash; });
    });
}

std::string toTable(const std::vector<SetReport>& reports) {
    std::string table =
        "set          polygons  vertices triangles  triangulator threads        ms    cpu ms    gpu ms  Mv/s  x CGAL "
        "B/vertex  verified  hash\n";
    for (const SetReport& report : reports) {
        const auto cgal = std::ranges::find_if(
            report.runs, [](const Run& r) { return r.triangulator == Triangulator::Cgal && r.threads == 1; });
        for (const Run& run : report.runs) {
            table += model::formatted(
                "%-12s %8zu %9zu %9zu  %-12s %7d %9.2f %9.2f %9.2f %5.2f %7.2f %8.0f  %-8s  %016llx\n",
                report.name.c_str(), report.polygons, report.vertices, report.triangles,
                std::string(nameOf(run.triangulator)).c_str(), run.threads, run.ms, run.cpuMs, run.deviceMs,
                1e-6 * verticesPerSecond(report, run), cgal == report.runs.end() ? 0.0 : cgal->ms / run.ms,
                run.bytesPerVertex, run.isVerified ? "yes" : "NO", static_cast<unsigned long long>(run.hash));
        }
    }
    return table;
}

std::string toJson(const std::vector<SetReport>& reports, const std::string& device, const std::string& commit) {
    nlohmann::json json = {{"device", device}, {"commit", commit}, {"sets", nlohmann::json::array()}};
    for (const SetReport& report : reports) {
        nlohmann::json runs = nlohmann::json::array();
        for (const Run& run : report.runs) {
            nlohmann::json row = {{"triangulator", nameOf(run.triangulator)},
                                  {"threads", run.threads},
                                  {"ms", run.ms},
                                  {"cpu_ms", run.cpuMs},
                                  {"vertices_per_s", verticesPerSecond(report, run)},
                                  {"bytes_per_vertex", run.bytesPerVertex},
                                  {"hash", model::formatted("%016llx", static_cast<unsigned long long>(run.hash))},
                                  {"verified", run.isVerified}};
            if (run.triangulator == Triangulator::Gpu) {
                row.update({{"device_ms", run.deviceMs},
                            {"steps", run.steps},
                            {"on_device", run.onDevice},
                            {"flagged", run.flagged}});
                if (!run.stageMs.empty()) {
                    row["stages_ms"] = run.stageMs;
                }
            }
            runs.push_back(std::move(row));
        }
        json["sets"].push_back({{"name", report.name},
                                {"polygons", report.polygons},
                                {"vertices", report.vertices},
                                {"triangles", report.triangles},
                                {"runs", runs}});
    }
    return model::jsonText(json);
}

}  // namespace tri::bench
