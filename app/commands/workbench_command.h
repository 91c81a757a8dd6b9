#pragma once

#include "app/common/open_board.h"
#include "ui/shell/interaction_bench.h"

namespace app {

/// `copperscope [BOARD]`: opens the desktop workbench. Returns an exit code; a build without the workbench says so and
/// returns kFailed.
int runWorkbench(int argc, char** argv, const model::OpenRequest& request);

/// As ui::measureInteraction; DeviceFailed too in a build without the workbench.
[[nodiscard]] base::Result<ui::InteractionReport> measureInWindow(const ui::InteractionRequest& request);

}  // namespace app
