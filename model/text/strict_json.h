#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/text/json_lines.h"

namespace model {

/// Our own files of JSON that people edit: comments are allowed, unknown keys and keys that are there twice are not,
/// and what is wrong is named by line and key.
class StrictJson {
public:
    using Json = nlohmann::ordered_json;

    /// `what` is in the file ("rules"), `versionKey` says so ("copperscope_rules": 1). Errors: BadInput.
    [[nodiscard]] static base::Result<StrictJson> parse(std::string_view text, std::string what,
                                                        const char* versionKey);

    [[nodiscard]] const Json& json() const { return m_json; }
    /// "line 12" of a path as JsonLines has it.
    [[nodiscard]] std::string lineOf(const std::string& path) const;
    [[nodiscard]] base::Error bad(const std::string& why) const;
    /// A key that nothing reads is a typing error; `path` is that of the object.
    [[nodiscard]] base::Status checkKeys(const Json& object, const std::string& path,
                                         std::span<const char* const> known) const;

private:
    StrictJson(std::string what, Json json, std::string_view text)
        : m_what(std::move(what)), m_json(std::move(json)), m_lines(text) {}

    std::string m_what;
    Json m_json;
    JsonLines m_lines;
};

}  // namespace model
