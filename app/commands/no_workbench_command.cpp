// Stands in for workbench_command.cpp in builds without Qt.
#include "app/commands/workbench_command.h"
#include "app/common/exit_code.h"

namespace app {

int runWorkbench(int, char**, const model::OpenRequest&) {
    return fail(
        {base::ErrorCode::DeviceFailed, "this build has no workbench; use copperscope info or copperscope render"});
}

base::Result<ui::InteractionReport> measureInWindow(const ui::InteractionRequest&) {
    return base::Error{base::ErrorCode::DeviceFailed, "this build has no workbench to measure"};
}

}  // namespace app
