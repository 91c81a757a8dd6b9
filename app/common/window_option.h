#pragma once

#include <vector>

#include "model/base/point.h"
#include "model/base/result.h"

namespace app {

/// What `--window X0,Y0,X1,Y1` says in millimetres, corners in any order, as a box in nm. Errors: BadUsage if it is
/// empty or larger than a board can be.
[[nodiscard]] base::Result<base::Box> boxOfWindow(const std::vector<double>& corners);

/// Errors: BadUsage if nothing of what has this extent lies in the window.
[[nodiscard]] base::Status checkMeets(const base::Box& window, const base::Box& extent);

}  // namespace app
