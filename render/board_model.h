#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/document.h"
#include "model/geometry/discretise.h"
#include "render/board_frame.h"
#include "shaders/shared/board.h"

namespace render {

/// A consecutive run of rows that belong to one layer.
struct LayerRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Areas of one shape on one layer: one instanced draw.
struct AreaBatch {
    std::uint32_t shape = 0;  ///< row of BoardModel::shapes
    std::uint32_t layer = 0;
    std::uint32_t firstInstance = 0;
    std::uint32_t instanceCount = 0;
};

/// The last two parts of the paper's modelling (Table 4), plus making the lets.
struct ModelTimes {
    double createMs = 0.0;
    double discretiseMs = 0.0;
    double triangulateMs = 0.0;
};

/// What a document becomes before it goes to the GPU, as plain arrays (paper: "hybrid pipeline"): lets for lines, arcs,
/// circles and trails, triangles for areas. Lengths in mm relative to `origin`. Everything is sorted by layer, so that
/// a layer is a run.
struct BoardModel : BoardFrame {
    std::vector<shader::Let> lets;
    std::vector<shader::Cluster> clusters;  ///< never straddle a layer
    std::vector<LayerRun> clustersOfLayer;

    std::vector<glm::vec2> vertices;  ///< top vertices of all shapes, each from its shape's centre
    std::vector<std::uint32_t> next;  ///< per vertex, the vertex its wall leads to; itself where no wall stands
    std::vector<std::uint32_t> indices;
    std::vector<shader::ShapeRecord> shapes;  ///< only shapes in use
    std::vector<shader::AreaInstance> instances;
    std::vector<AreaBatch> areaBatches;
    std::vector<LayerRun> areaBatchesOfLayer;

    std::uint64_t trianglesPaperRule =
        0;  ///< triangles the standard pipeline would store for this board (triangulation-facts §1.3)
    std::uint32_t repairedAreas = 0;  ///< areas whose outline crossed itself and went through integer booleans
    std::uint32_t emptyAreas = 0;     ///< areas without any area
    ModelTimes times;
    model::Diagnostics diagnostics;  ///< what was repaired or dropped here, with file and line
};

/// Makes lets and triangulates all areas, one area per task over all cores. Same result with 1 and N threads.
/// Errors: Cancelled.
[[nodiscard]] base::Result<BoardModel> buildBoardModel(const model::Document& document,
                                                       const model::Discretisation& how, base::Progress& progress);

}  // namespace render
