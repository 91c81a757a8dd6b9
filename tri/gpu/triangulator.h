#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "tri/gpu/device_forest.h"

namespace tri::gpu {

/// What became of the polygons of a call.
struct Tally {
    std::size_t onDevice = 0;     ///< triangulated and proven there
    std::size_t flagged = 0;      ///< given up there and done on the CPU: contours through vertices, crossings, ...
    std::size_t withoutTree = 0;  ///< never went there: no area, or too large for the device
    std::uint32_t steps = 0;
    std::uint32_t rounds = 0;  ///< steps that inserted vertices
    std::uint32_t flips = 0;
    std::uint64_t deviceBytes = 0;          ///< of device memory, at most
    double deviceMs = 0.0;                  ///< time of the kernels; 0 if the device cannot tell
    std::map<std::string, double> stageMs;  ///< by kernel, where they are timed
};

/// Triangulates all polygons of a board in the same dispatches (docs/triangulation.md). The result is the same,
/// triangle by triangle, as that of every other triangulator; what the device cannot do goes to the CPU and is counted.
/// Memory: about 230 bytes per vertex on the device; what does not fit goes there in several turns. Use it from the
/// device's thread. If the device is lost or has no memory left, the CPU does what is left.
class Triangulator {
public:
    /// Makes the pipelines. `device` has to outlive this.
    explicit Triangulator(render::gpu::Device& device);

    /// Reports how many vertices are in; after a cancel the results are of no use.
    [[nodiscard]] std::vector<Triangulation> triangulate(std::span<const Polygon> polygons, base::Progress& progress,
                                                         Eraser eraser = Eraser::Sector);
    /// As FrameRing::timeStages.
    void timeStages() { m_ring.timeStages(); }
    /// About the last call.
    [[nodiscard]] const Tally& tally() const { return m_tally; }

private:
    [[nodiscard]] std::size_t endOfTurn(std::span<const Polygon> polygons, std::size_t first) const;
    void triangulateBatch(std::span<const Polygon> polygons, Eraser eraser, base::Progress& progress,
                          std::span<Triangulation> results);
    [[nodiscard]] bool grow(const DeviceForest& forest, base::Progress& progress);
    void harvest(const DeviceForest& forest, const ForestData& data, std::span<Triangulation> results);

    render::gpu::Device* m_device;
    render::gpu::FrameRing m_ring;
    Kernels m_kernels;
    Tally m_tally;
};

}  // namespace tri::gpu
