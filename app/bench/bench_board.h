#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "app/bench/bench_command.h"
#include "render/frame/offscreen_presenter.h"
#include "render/gpu/device.h"
#include "render/standard/standard_model.h"

namespace app {

/// Median time of one view of a scene, 1920 × 1080 in 3D, one sample per pixel.
struct FrameResult {
    std::string view;      ///< "whole", "5x", "30x": from the corner, then closer to the middle of its upper side
    std::string backend;   ///< that drew: "pull", "mesh", …, "standard"
    bool isAuto = false;   ///< the one that `--backend auto` takes
    bool isCulled = true;  ///< frustum culling and level of detail
    double ms = 0.0;
    std::map<std::string, double> stageMs;  ///< medians by stage, where they were timed
    std::uint64_t triangles = 0;
    double greyMse = -1.0;  ///< against the standard pipeline's picture; -1 if that was not drawn
};

/// The paper's Table 4 and memory of one pipeline. Reading is everything up to the document, which both share.
struct PipelineResult {
    std::string name;  ///< "hybrid", "standard"
    double parseMs = 0.0;
    double createMs = 0.0;
    double discretiseMs = 0.0;
    double triangulateMs = 0.0;
    double uploadMs = 0.0;
    std::uint64_t gpuBytes = 0;
    std::uint64_t cpuBytes = 0;
    std::uint64_t triangles = 0;  ///< stored
    std::vector<FrameResult> frames;

    /// Modelling after parsing.
    [[nodiscard]] double modellingMs() const { return createMs + discretiseMs + triangulateMs + uploadMs; }
};

struct BoardResult {
    std::string name;
    std::array<std::uint64_t, model::kElementKindCount> elements{};
    std::vector<PipelineResult> pipelines;

    [[nodiscard]] std::uint64_t elementCount() const;
};

/// Reads a board and measures the pipelines one after the other, so that they run under the same load.
/// Errors: as model::readBoard; DeviceFailed.
[[nodiscard]] base::Result<BoardResult> benchBoard(render::gpu::Device& device, const std::string& path,
                                                   const BenchArguments& arguments);

}  // namespace app
