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
    std::vector<StandardModel> steps;  ///< at whatever depth; they have none themselves
    std::vector<StandardPart> parts;   ///< sorted by layer
    std::uint32_t elementCount = 0;
    ModelTimes times;  ///< create: vertices and walls out of outlines

    [[nodiscard]] std::uint64_t triangles() const;  ///< stored: each step counts once
};

/// Over all cores, a thousand elements per task; same result with 1 and N threads. The opposite end of a prism reuses
/// the triangulation of its top. Errors: Cancelled.
[[nodiscard]] base::Result<StandardModel> buildStandardModel(const model::Document& document,
                                                             const model::Discretisation& how,
                                                             base::Progress& progress);

}  // namespace render
