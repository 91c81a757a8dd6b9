#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The messages panel: what was skipped, repaired or assumed while the board was opened. A message that is chosen is
/// shown: its element is selected, its layer visible.
void addMessages(FeatureContext& context);

}  // namespace ui
