#pragma once

#include <string>

#include "app/manual/manual.h"

namespace app {

/// A file for bash that completes commands, options, choices and files.
[[nodiscard]] std::string bashCompletion(const ManualCommand& program);

/// The same for zsh, with what commands and options do.
[[nodiscard]] std::string zshCompletion(const ManualCommand& program);

}  // namespace app
