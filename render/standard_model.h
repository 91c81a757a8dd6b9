#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/geometry/discretise.h"
#include "render/board_frame.h"
#include "shaders/shared/board.h"

namespace render {

/// Elements of one layer as one vertex and one index buffer.
struct StandardPart {
    std::uint32_t layer = 0;
    std::vector<shader::StandardVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise from outside; into `vertices`
};

/// What the paper compares with ("standard pipeline"): every element of the board itself, repeated pads
/// included but not those of the steps it places (Document::instances), is inflated by its pen, its curves become
/// chords, its outline is triangulated, and the prism between its layer's faces goes to the GPU as triangles: top,
/// bottom and walls.
struct StandardModel : BoardFrame {
    std::vector<StandardPart> parts;  ///< sorted by layer
    std::vector<bool> hasAreas;       ///< by layer
    std::uint32_t elementCount = 0;

    /// The last three parts of the paper's modelling (Table 4). Create: vertices and walls out of outlines.
    struct Times {
        double createMs = 0.0;
        double discretiseMs = 0.0;
        double triangulateMs = 0.0;
    } times;

    [[nodiscard]] std::uint64_t triangles() const;
    [[nodiscard]] std::uint64_t bytes() const;  ///< of vertices and indices
};

/// Over all cores, a thousand elements per task; same result with 1 and N threads. The opposite end of a prism reuses
/// the triangulation of its top. Errors: Cancelled.
[[nodiscard]] base::Result<StandardModel> buildStandardModel(const model::Document& document,
                                                             const model::Discretisation& how,
                                                             base::Progress& progress);

}  // namespace render
