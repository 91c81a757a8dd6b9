#pragma once

#include "model/solids/shells/shell.h"

namespace model {

/// The region of a straight track: two lines and two half circles, or with a square pen the hull of the pen at both
/// ends. With an inner width, a plated slot: that of the pen without that of the drill. Empty when nothing is left.
[[nodiscard]] EdgeLoops lineOutline(const LineGeometry& line, bool hasSquarePen);

}  // namespace model
