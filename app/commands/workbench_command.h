#pragma once

#include "app/common/open_board.h"

namespace app {

/// `copperscope [BOARD]`: opens the desktop workbench. Returns an exit code; a build without the workbench says so and
/// returns kFailed.
int runWorkbench(int argc, char** argv, const model::OpenRequest& request);

}  // namespace app
