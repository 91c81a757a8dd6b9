#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/geometry/discretise.h"
#include "render/modelling/board_frame.h"
#include "shaders/shared/board.h"

namespace render {

/// Elements of one layer as one vertex and one index buffer.
struct StandardPart {
    std::uint32_t layer = 0;
    std::vector<shader::StandardVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise from outside; into `vertices`
};

/// What the paper compares with ("standard pipeline"): every element, repeated pads included, is inflated by its pen,
/// its curves become chords, its outline is triangulated, and the prism between its layer's faces goes to the GPU as
/// triangles: top, bottom and walls. Steps that a panel places are models of their own, stored once however often they
/// are drawn. Bodies of components in flipped copies stand on the wrong face of their layer: vertices do not know the
/// body's height.
struct StandardModel : BoardFrame {
    std::vector<StandardModel> steps;                           ///< at whatever depth; they have none themselves
    std::vector<ModelCopy> copies = std::vector<ModelCopy>(1);  ///< rows as in model::StepTree: the board itself first
    std::vector<model::LayerId> opposite;  ///< Layer::opposite per layer; empty where there are no copies

    std::vector<StandardPart> parts;  ///< sorted by layer
    std::vector<bool> hasAreas;       ///< by layer
    std::uint32_t elementCount = 0;

    /// The last three parts of the paper's modelling (Table 4). Create: vertices and walls out of outlines.
    struct Times {
        double createMs = 0.0;
        double discretiseMs = 0.0;
        double triangulateMs = 0.0;
    } times;

    [[nodiscard]] std::uint64_t triangles() const;  ///< stored: each step counts once, as in bytes()
    [[nodiscard]] std::uint64_t bytes() const;      ///< of vertices and indices
};

/// Over all cores, a thousand elements per task; same result with 1 and N threads. The opposite end of a prism reuses
/// the triangulation of its top. Errors: Cancelled.
[[nodiscard]] base::Result<StandardModel> buildStandardModel(const model::Document& document,
                                                             const model::Discretisation& how,
                                                             base::Progress& progress);

}  // namespace render
