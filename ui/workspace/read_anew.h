#pragma once

#include "ui/workspace/workspace.h"

namespace ui {

/// Is the next board (Workspace::boardLeaves) the one on the screen, read anew: the same step of the same file in the
/// same format? What is shown of it then stays (decision 174).
[[nodiscard]] bool isReadAnew(const Workspace& workspace, const LoadedBoard& next);

/// Is it another step of that?
[[nodiscard]] bool isOtherStep(const Workspace& workspace, const LoadedBoard& next);

}  // namespace ui
