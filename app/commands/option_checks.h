#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace app {

/// After parsing: why the command that was chosen cannot be done as it is given, a sentence. A number is not finite, or
/// a file that is read would be written over. Else none.
[[nodiscard]] std::optional<std::string> unusableOption(const CLI::App& parser);

}  // namespace app
