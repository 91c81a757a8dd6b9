#pragma once

#include <cstdint>

#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace render {

/// Triangles the standard pipeline would store for the job's own layers with all copies of steps: the paper's Table 2,
/// reproduced to the triangle for its model t1 (docs/performance.md). Counted, not built.
[[nodiscard]] std::uint64_t countStandardTriangles(const model::Document& document, const model::Discretisation& how);

}  // namespace render
