#pragma once

#include "model/geometry/boolean.h"

namespace model {

/// Do the loops keep clear of each other and of themselves, even when they are rounded to the grid? On each of the
/// level lines through their corners, two sides are at different x when each is rounded to a whole nanometre, but where
/// they share a corner on it; and from one of these lines to the next they do not change places. No side runs back
/// along the one before it.
///
/// Errs to "no". Costs n log n.
[[nodiscard]] bool areClear(const LoopSet& loops);

}  // namespace model
