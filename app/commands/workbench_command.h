#pragma once

#include <string>
#include <vector>

namespace app {

struct WorkbenchArguments {
    std::string path;  ///< empty: the bundled sample
    std::string step;
    std::vector<std::string> thicknesses;  ///< as BoardArguments, and so the rest
    bool noSession = false;
    bool inferNets = false;
};

/// `copperscope [BOARD]`: opens the desktop workbench. Returns an exit code; a build without the workbench says so and
/// returns kFailed.
int runWorkbench(int argc, char** argv, const WorkbenchArguments& arguments);

}  // namespace app
