#pragma once

#include <vector>

#include "render/modelling/board_model.h"
#include "shaders/shared/frame.h"

namespace render {

/// Boxes around what the shapes of a step draw, in their order, and how far each strays from its shape: as far as the
/// farthest corner, where the shape is convex and drawn as nothing but triangles; any other shape counts as a point.
[[nodiscard]] std::vector<shader::ShapeBound> boundsOf(const BoardModel& model);

}  // namespace render
