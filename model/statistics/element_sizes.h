#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// Length of the middle line of a track in nanometres; 0 for circles and areas.
[[nodiscard]] double lengthOf(const Document& document, ElementId element);

/// What an element covers in nm², arcs exactly. Tracks of a trail that overlap at their joints count once there: each
/// joint is taken as a round one, which is exact for trails that do not cross themselves and whose tracks are longer
/// than the pen is wide. A hole is what the drill removes.
[[nodiscard]] double areaOf(const Document& document, ElementId element);

/// What the elements of each layer cover together in nm², with those of all copies; 0 for layers other than copper.
/// What overlaps counts twice.
[[nodiscard]] std::vector<double> copperAreas(const Document& document);

}  // namespace model
