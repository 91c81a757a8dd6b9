#pragma once

#include <functional>

namespace app {

/// What the command line requests, ready to run; returns the exit code.
using Command = std::function<int()>;

/// Understands the command line of docs/command-line.md. Help and wrong arguments are printed here: then the command
/// does nothing but return the code.
[[nodiscard]] Command parseCommandLine(int argc, char** argv);

}  // namespace app
