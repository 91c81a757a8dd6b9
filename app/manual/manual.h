#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace app {

/// What may stand after an option.
enum class ValueKind {
    None,    ///< a flag
    Free,    ///< something only the user knows: a name, a length, a number
    File,    ///< a path
    Choice,  ///< one of ManualOption::choices
};

/// An option or argument as `--help` has it.
struct ManualOption {
    std::vector<std::string> names;  ///< "-o", "--output"; of an argument its only name, BOARD
    ValueKind value = ValueKind::None;
    std::string form;                  ///< "FILE", "UINT"; empty for flags and arguments
    std::string range;                 ///< "1 - 1000000", empty if there is none
    std::vector<std::string> choices;  ///< of ValueKind::Choice
    std::string standard;              ///< the value without it; empty if none is shown
    std::string text;
    bool isRequired = false;
    bool isRepeatable = false;
};

/// A command, or the program itself with its commands.
struct ManualCommand {
    std::string name;
    std::string summary;
    std::string footer;
    std::vector<ManualOption> arguments;
    std::vector<ManualOption> options;
    std::vector<ManualCommand> commands;
};

/// Reads a command line from its parser, so that manual, completion and `--help` are one.
[[nodiscard]] ManualCommand readManual(const CLI::App& parser);

}  // namespace app
