#pragma once

#include <optional>
#include <string>

#include "ui/workspace/loader.h"

/// The door from app/ into the desktop workbench.
namespace ui {

struct StartOptions {
    std::optional<model::OpenRequest> board;  ///< opened at the start
    std::string device;                       ///< part of a Vulkan device's name; empty: the best one
};

/// Shows the window and returns when it is closed. Answers the exit code of the program: 0, or 3 after saying on stderr
/// why no window can be shown (no display; no usable Vulkan device: to who starts from a menu a dialog says it too).
[[nodiscard]] int runWorkbench(int argc, char** argv, const StartOptions& options);

}  // namespace ui
