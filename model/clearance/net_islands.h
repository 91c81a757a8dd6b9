#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/clearance/layer_geometry.h"

namespace model {

/// The net of every figure of a layer geometry as a row of Document::nets. Figures without a net (text, shapes,
/// teardrops) take the net that they touch, directly or by more such figures, of several the lowest; those that touch
/// none take one row more than there are nets. Over all cores, the same with any number of threads; partial once
/// `progress` is cancelled.
[[nodiscard]] std::vector<std::uint32_t> netsByTouch(const Document& document, const LayerGeometry& plane,
                                                     base::Progress& progress);

}  // namespace model
