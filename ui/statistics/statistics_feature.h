#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The statistics panel: elements, drills and how sizes are spread; what is chosen in it is selected.
void addStatistics(FeatureContext& context);

}  // namespace ui
