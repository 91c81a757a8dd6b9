#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The element panel: what is known of the element selected last, with links to what it belongs to.
void addElement(FeatureContext& context);

}  // namespace ui
