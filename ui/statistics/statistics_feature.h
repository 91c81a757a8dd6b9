#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The statistics panel: the board in a line (size, thickness, counts), below it elements by kind per layer and in all,
/// behind a second tab the drill table, and beside them how track widths, holes or annular rings are spread. What is
/// chosen in it is selected.
void addStatistics(FeatureContext& context);

}  // namespace ui
