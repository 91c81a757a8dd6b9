#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// JSON as the commands print it: indented, with a line break behind it. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace app
