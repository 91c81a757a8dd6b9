#include "model/export/side_json.h"

namespace model {

nlohmann::ordered_json sideJson(const Side& side) {
    nlohmann::ordered_json json{{"net", side.net}};
    if (!side.pin.empty()) {
        json["pin"] = side.pin;
    }
    if (side.element.isValid()) {
        json["kind"] = side.kind;
        json["element"] = side.element.value;
    }
    return json;
}

}  // namespace model
