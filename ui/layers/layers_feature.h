#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The layers panel, and the commands of the menu Layers.
void addLayers(FeatureContext& context);

}  // namespace ui
