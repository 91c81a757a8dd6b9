#pragma once

#include "model/board/document.h"
#include "model/geometry/loops/edge_loops.h"

namespace model {

/// The closed surface of one solid of a board: a prism (paper, 3D shells). Its lower and upper face are planes with the
/// outline and the holes of a region; between them stands a wall per edge, a plane on a line and part of a cylinder on
/// an arc. Oriented and two-manifold when the loops neither touch nor cross each other or themselves.
///
/// Lengths are nanometres; heights as in the document, from the lowest face of the bottom copper layer.
struct Shell {
    EdgeLoops outline;
    ZRange z;
};

/// In nm³.
[[nodiscard]] inline double volumeOf(const Shell& shell) {
    return areaOf(shell.outline) * (static_cast<double>(shell.z.top) - shell.z.bottom);
}

}  // namespace model
