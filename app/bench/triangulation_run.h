#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/triangulation_sets.h"
#include "tri/gpu/triangulator.h"

namespace tri::bench {

/// One triangulator over one set with so many threads.
struct Run {
    Triangulator triangulator = Triangulator::Cpu;
    int threads = 1;
    double ms = 0.0;                          ///< best of the repeats, from input to triangles
    double deviceMs = 0.0;                    ///< Gpu: time of the kernels in that repeat
    std::map<std::string, double> stageMs{};  ///< Gpu: by kernel, where they were timed
    double cpuMs = 0.0;  ///< processor time of all threads in that repeat; far from ms * threads: the machine was busy
    /// How much the process grew at its peak, output included; for Gpu the device's memory. What earlier runs gave back
    /// is used again first, so only the first run of a process shows all of it.
    double bytesPerVertex = 0.0;
    std::uint64_t hash = 0;    ///< of all triangle sets
    bool isVerified = false;   ///< verify() found no fault in any of them
    std::uint32_t steps = 0;   ///< Gpu: of growing the forest
    std::size_t onDevice = 0;  ///< Gpu: polygons that needed no help
    std::size_t flagged = 0;   ///< Gpu: polygons that the CPU had to do
};

struct SetReport {
    std::string name;
    std::size_t polygons = 0;
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::vector<Run> runs;
};

struct Options {
    std::vector<Triangulator> triangulators = {Triangulator::Cgal, Triangulator::Cpu, Triangulator::Parallel};
    std::vector<int> threads = {1, 2};
    gpu::Triangulator* device = nullptr;  ///< has to be there for Triangulator::Gpu
    int repeats = 3;
};

/// Measures all triangulators on one set. CGAL and Cpu take one polygon per task, the largest first; Parallel one
/// polygon after the other; Gpu all at once, copies to and from the device included, for every number of threads alike:
/// it is measured once.
[[nodiscard]] SetReport measure(const Set& set, const Options& options);

/// Has every run of a set the same triangles, and did the verifier accept them?
[[nodiscard]] bool isAllEqual(const std::vector<SetReport>& reports);

/// A row per run, with the times against CGAL on one thread if that was measured.
[[nodiscard]] std::string toTable(const std::vector<SetReport>& reports);

/// {device, commit, sets[]{name, polygons, vertices, triangles, runs[]{triangulator, threads, ms, cpu_ms,
/// vertices_per_s, bytes_per_vertex, hash, verified}}}; runs of gpu have device_ms, on_device and flagged as well.
[[nodiscard]] std::string toJson(const std::vector<SetReport>& reports, const std::string& device,
                                 const std::string& commit);

}  // namespace tri::bench
