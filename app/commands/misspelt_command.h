#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace app {

/// After parsing: the first word was taken for a board, but no file has that name and it reads like a command (neither
/// an ending nor a folder). A sentence that names it and the command that is spelt most like it; else none.
[[nodiscard]] std::optional<std::string> misspeltCommand(const CLI::App& parser);

}  // namespace app
