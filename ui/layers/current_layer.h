#pragma once

#include "ui/workspace/workspace.h"

namespace ui {

/// For commands that are about the current layer. Where there is none, one becomes it: the layer of what the pointer is
/// on or what was chosen last, else the top copper. None without a board, and on one without copper.
model::LayerId takeCurrentLayer(Workspace& workspace);

}  // namespace ui
