#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "shaders/shared/board.h"

namespace render {

struct BoardModel;

/// A closed line; the last point leads to the first.
using Loop = std::vector<glm::vec2>;

/// Visits the walls of an area instance as loops, where it lies on the board, mm. `instance.shape` is whole: before
/// cutIntoPieces.
void forLoops(const BoardModel& model, const shader::AreaInstance& instance,
              const std::function<void(const Loop&)>& visit);

}  // namespace render
