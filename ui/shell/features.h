#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// Makes every feature of the window: a row in the table of features.cpp.
void addFeatures(FeatureContext& context);

}  // namespace ui
