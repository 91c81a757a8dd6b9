#include "model/text/json_reading.h"

namespace model {

using nlohmann::json;

const json& memberOf(const json& object, const char* key) {
    static const json kNull;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : kNull;
}

std::string stringOf(const json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace model
