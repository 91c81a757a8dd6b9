#pragma once

#include <functional>

#include "model/clearance/layer_geometry.h"

namespace model {

/// Does something that is wanted (by row) cover the middle of a spacing?
[[nodiscard]] bool isBridged(const LayerGeometry& geometry, const Spacing& spacing,
                             const std::function<bool(std::uint32_t)>& isWanted);
/// Does it cover a point?
[[nodiscard]] bool isCovered(const LayerGeometry& geometry, PointD point,
                             const std::function<bool(std::uint32_t)>& isWanted);

}  // namespace model
