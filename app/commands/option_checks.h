#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace app {

/// For a parser with all its commands: what of an option would do nothing beside or without another one is refused, so
/// that nobody takes it for done. What follows from values (`--mode 2d`) the commands refuse themselves.
void limitCombinations(CLI::App& parser);

/// After parsing: why the command that was chosen cannot be done as it is given, a sentence. An option stands
/// before the command, which would not see it; a file that is read, or one that is read with the board
/// (isReadFor), would be written over. Else none.
[[nodiscard]] std::optional<std::string> unusableOption(const CLI::App& parser);

}  // namespace app
