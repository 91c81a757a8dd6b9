#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "model/base/limits.h"
#include "model/base/result.h"

namespace model {

/// JSON that comes from outside as values, comments allowed. `Json` is one of nlohmann's types. Values nested deeper
/// than base::kMostJsonDepth are refused: to copy or to write them would take as many calls within calls. Errors:
/// BadInput, with the place.
template <class Json>
[[nodiscard]] base::Result<Json> readJson(std::string_view text) {
    bool isTooDeep = false;
    const auto keep = [&isTooDeep](int depth, typename Json::parse_event_t, const Json&) {
        isTooDeep = isTooDeep || static_cast<std::size_t>(depth) > base::kMostJsonDepth;
        return !isTooDeep;
    };
    try {
        Json json = Json::parse(text, keep, true, true);
        if (!isTooDeep) {
            return json;
        }
    } catch (const typename Json::exception& error) {
        const std::string_view why = error.what();  // "[json.exception.parse_error.101] parse error at line 1, …"
        const std::size_t name = why.starts_with('[') ? why.find("] ") : std::string_view::npos;
        return base::Error{
            base::ErrorCode::BadInput,
            "this is no file of JSON: " + std::string(name == std::string_view::npos ? why : why.substr(name + 2))};
    }
    return base::Error{base::ErrorCode::BadInput, "its values have " + base::moreThan(base::kMostJsonDepth, "levels")};
}

/// What an object has under a key; null if it has nothing there, or is no object.
[[nodiscard]] const nlohmann::json& memberOf(const nlohmann::json& object, const char* key);
/// The text that a value is; empty if it is none.
[[nodiscard]] std::string stringOf(const nlohmann::json& value);

}  // namespace model
