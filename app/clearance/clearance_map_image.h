#pragma once

#include <string>

#include "model/clearance/clearance_map.h"
#include "render/scene/view_settings.h"

namespace app {

/// A clearance map as a picture, a cell per pixel, as seen from above: copper grey, what is farther than `reach` (nm)
/// dark, the rest in the colours that the window has. To the right of it a legend with `title` says what they mean.
[[nodiscard]] render::Image imageOf(const model::ClearanceMap& map, double reach, const std::string& title);

}  // namespace app
