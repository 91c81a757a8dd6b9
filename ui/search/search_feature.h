#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The search box, and where it leads: what is found is selected, highlighted or shown.
void addSearch(FeatureContext& context);

}  // namespace ui
