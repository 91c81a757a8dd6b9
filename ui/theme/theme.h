#pragma once

#include "ui/workspace/settings.h"

namespace ui {

/// Colours of panels, menus and dialogs of the whole application; the canvas keeps its own dark ground. System gives
/// the desktop's.
void applyTheme(Theme theme);

}  // namespace ui
