#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"
#include "render/modelling/area_meshes.h"
#include "render/modelling/board_frame.h"
#include "render/modelling/body_shadows.h"
#include "render/modelling/substrate_margins.h"
#include "shaders/shared/board.h"

namespace render {

/// A consecutive run of rows that belong to one layer.
struct LayerRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// A triangulated shape, or a piece of one (area_pieces.h): top vertices, triangles and walls stored once, bottom made
/// from them.
struct AreaShape {
    std::uint32_t firstVertex = 0;
    std::uint32_t vertexCount = 0;  ///< of the whole shape
    std::uint32_t firstIndex = 0;   ///< into `indices`, whose values count from firstVertex
    std::uint32_t triangleCount = 0;
    std::uint32_t firstWall = 0;  ///< vertex where the first wall starts
    std::uint32_t wallCount = 0;
};

/// Areas of one shape on one layer: one instanced draw.
struct AreaBatch {
    std::uint32_t shape = 0;  ///< row of BoardModel::shapes
    std::uint32_t layer = 0;
    std::uint32_t firstInstance = 0;
    std::uint32_t instanceCount = 0;
};

/// What a document becomes before it goes to the GPU, as plain arrays (paper: "hybrid pipeline"): lets for lines, arcs,
/// circles and trails, triangles for areas. Lengths in mm relative to `origin`. Everything is sorted by layer, so that
/// a layer is a run. The steps that a panel places are models of their own, made once however often they are drawn.
struct BoardModel : BoardFrame {
    std::vector<BoardModel> steps;   ///< at whatever depth; they have none themselves
    std::uint32_t elementCount = 0;  ///< of the document, drawn or not

    std::vector<shader::Let> lets;
    std::vector<shader::Cluster> clusters;  ///< never straddle a layer
    std::vector<LayerRun> clustersOfLayer;

    std::vector<glm::vec2> vertices;  ///< top vertices of all shapes, each from its shape's centre
    std::vector<std::uint32_t> next;  ///< per vertex, the vertex its wall leads to; itself where there is no wall
    std::vector<std::uint32_t> indices;
    std::vector<AreaShape> shapes;  ///< pieces of the shapes in use
    std::vector<shader::AreaInstance> instances;
    std::vector<AreaBatch> areaBatches;
    std::vector<LayerRun> areaBatchesOfLayer;
    std::vector<LayerInSubstrate> inSubstrate;  ///< by layer; empty: nothing is known
    BodyShadows shadows;
    std::vector<model::ElementId> milled;  ///< rising (model/solids/milling.h): held as designed and as fabricated

    std::uint32_t repairedAreas = 0;  ///< areas whose outline crossed itself and went through integer booleans
    std::uint32_t emptyAreas = 0;     ///< areas without any area
    ModelTimes times;                 ///< create: lets too
    model::Diagnostics diagnostics;   ///< what was repaired or dropped here, with file and line
};

/// Makes lets and triangulates all areas of the board and of every step it places, over all cores or on a device. Same
/// result with 1 and N threads and with every triangulator. The board's `times` and `diagnostics` are those of all
/// steps. Errors: Cancelled.
[[nodiscard]] base::Result<BoardModel> buildBoardModel(const model::Document& document,
                                                       const model::Discretisation& how, base::Progress& progress,
                                                       const AreaTriangulator& triangulator = {});

/// Of every document the elements that are milled away, as model::SectionRequest has them.
[[nodiscard]] std::vector<std::vector<model::ElementId>> milledOfSteps(const BoardModel& board);

/// What a board model holds, over all steps, for reports.
struct ModelCounts {
    std::size_t lets = 0;
    std::size_t shapes = 0;       ///< triangulated, each once
    std::size_t instances = 0;    ///< places that shapes lie at
    std::uint64_t triangles = 0;  ///< stored: of tops, and bottoms are made from them
    ModelTimes times;
    model::Diagnostics diagnostics;  ///< the same as the model's
};

/// Makes what `buildBoardModel` makes, without what only drawing needs, and counts it. Errors: Cancelled.
[[nodiscard]] base::Result<ModelCounts> countBoardModel(const model::Document& document,
                                                        const model::Discretisation& how, base::Progress& progress,
                                                        const AreaTriangulator& triangulator = {});

}  // namespace render
