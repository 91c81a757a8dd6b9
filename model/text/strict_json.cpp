#include "model/text/strict_json.h"

#include <algorithm>
#include <vector>

#include "model/text/formatting.h"
#include "model/text/json_reading.h"

namespace model {

namespace {

base::Error unusable(const std::string& what, const std::string& why) {
    return {base::ErrorCode::BadInput, "the " + what + " cannot be used: " + why};
}

}  // namespace

base::Result<StrictJson> StrictJson::parse(std::string_view text, std::string what, const char* versionKey) {
    base::Result<Json> read = readJson<Json>(text);
    if (!read) {
        return unusable(what, read.error().text);
    }
    Json& json = *read;
    if (!json.is_object() || json.value(versionKey, Json()) != 1) {
        return unusable(what, "this is no file of Copperscope's " + what + " of version 1 (\"" + versionKey + "\": 1)");
    }
    StrictJson file(std::move(what), std::move(json), text);
    const std::string& twice = file.m_lines.duplicate();
    if (!twice.empty()) {
        return file.bad(file.lineOf(twice) + ": the key " + twice.substr(twice.rfind('/') + 1) + " is there twice");
    }
    return file;
}

std::string StrictJson::lineOf(const std::string& path) const {
    return "line " + std::to_string(m_lines.of(path));
}

base::Error StrictJson::bad(const std::string& why) const {
    return unusable(m_what, why);
}

base::Status StrictJson::checkKeys(const Json& object, const std::string& path,
                                   std::span<const char* const> known) const {
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::none_of(known, [&key = key](const char* name) { return key == name; })) {
            const std::vector<std::string> names(known.begin(), known.end());
            return bad(lineOf(path + '/' + key) + ": unknown key \"" + key + "\"; there are " + joined(names));
        }
    }
    return base::Done{};
}

}  // namespace model
