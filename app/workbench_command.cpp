#include "app/workbench_command.h"

#include "app/exit_code.h"
#include "app/resources.h"
#include "ui/workbench.h"

namespace app {

int runWorkbench(int argc, char** argv, const WorkbenchArguments& arguments) {
    ui::StartOptions options;
    options.board = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path);
    options.step = arguments.step;
    return ui::runWorkbench(argc, argv, options);
}

}  // namespace app
