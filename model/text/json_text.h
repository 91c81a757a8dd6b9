#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace model {

/// JSON as files and commands have it: indented, with a line break behind it. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] inline std::string jsonText(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace model
