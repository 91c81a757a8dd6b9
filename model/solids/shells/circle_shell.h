#pragma once

#include "model/solids/shells/shell.h"

namespace model {

/// The region of a disc, or of a ring (with a height, the tube of a plated hole). Empty when nothing is left, as of an
/// NPTH.
[[nodiscard]] EdgeLoops circleOutline(const CircleGeometry& circle);

}  // namespace model
