#include "app/workbench_command.h"

#include "app/exit_code.h"
#include "app/resources.h"
#include "ui/workbench.h"

namespace app {

int runWorkbench(int argc, char** argv, const WorkbenchArguments& arguments) {
    ui::StartOptions options;
    options.board = ui::LoadRequest{
        .path = arguments.path.empty() ? sampleBoard() : std::filesystem::path(arguments.path),
        .step = arguments.step,
        .thicknesses = arguments.thicknesses,
        .noSession = arguments.noSession,
        .inferNets = arguments.inferNets,
    };
    return ui::runWorkbench(argc, argv, options);
}

}  // namespace app
