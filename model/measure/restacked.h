#pragma once

#include "model/board/document.h"
#include "model/measure/measurement.h"

namespace model {

/// A measurement made with the heights of `before`, as it is with those of `now`, the same board with another stackup:
/// ΔZ between its layers, the height of the holes of a net path, and the notes on assumed thicknesses follow. One that
/// has the heights of `now` stays, and so does what lies on layers that the board does not have.
[[nodiscard]] Measurement restacked(const Document& before, const Document& now, Measurement measurement);

}  // namespace model
