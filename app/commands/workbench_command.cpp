#include "app/commands/workbench_command.h"

#include "app/common/exit_code.h"
#include "app/common/memory_limit.h"
#include "ui/shell/workbench.h"

namespace app {

int runWorkbench(int argc, char** argv, const model::OpenRequest& request) {
    if (const base::Status room = checkRoomForDevice(); !room) {
        return fail(room.error());
    }
    ui::StartOptions options;
    options.board = orSample(request);
    return ui::runWorkbench(argc, argv, options);
}

base::Result<ui::InteractionReport> measureInWindow(const ui::InteractionRequest& request) {
    return ui::measureInteraction(request);
}

}  // namespace app
