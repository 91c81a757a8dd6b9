#pragma once

#include <functional>
#include <memory>

namespace CLI {
class App;
}

namespace app {

/// What the command line requests, ready to run; returns the exit code.
using Command = std::function<int()>;

/// The parser with all commands and options: what `--help`, the man pages and completions (app/manual) are made of.
/// `chosen` must outlive it, and is set by parsing.
[[nodiscard]] std::shared_ptr<CLI::App> makeCommandLine(int argc, char** argv, Command& chosen);

/// Understands the command line of docs/command-line.md. Help and wrong arguments are printed here: then the command
/// does nothing but return the code.
[[nodiscard]] Command parseCommandLine(int argc, char** argv);

}  // namespace app
