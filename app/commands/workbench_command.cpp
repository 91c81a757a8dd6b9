#include "app/commands/workbench_command.h"

#include "app/common/exit_code.h"
#include "app/common/resources.h"
#include "ui/shell/workbench.h"

namespace app {

int runWorkbench(int argc, char** argv, const WorkbenchArguments& arguments) {
    ui::StartOptions options;
    options.board = model::OpenRequest{
        .path = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path),
        .step = arguments.step,
        .thicknesses = arguments.thicknesses,
        .noSession = arguments.noSession,
        .inferNets = arguments.inferNets,
    };
    return ui::runWorkbench(argc, argv, options);
}

}  // namespace app
