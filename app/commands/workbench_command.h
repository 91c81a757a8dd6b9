#pragma once

#include "app/commands/command_line.h"

namespace app {

/// `copperscope [BOARD]`: opens the desktop workbench. Answers an exit code; a build without the workbench says so and
/// answers kFailed.
int runWorkbench(int argc, char** argv, const WorkbenchArguments& arguments);

}  // namespace app
