#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The 2D and 3D views: cameras, what is drawn over the board, appearance, pictures.
void addViews(FeatureContext& context);

}  // namespace ui
