#pragma once

#include <nlohmann/json.hpp>

#include "model/clearance/side_names.h"

namespace model {

/// {"net": "GND", "pin": "U5.3", "kind": "pad", "element": 1234}; without a pin where there is none, of what is no
/// element the net alone.
[[nodiscard]] nlohmann::ordered_json sideJson(const Side& side);

}  // namespace model
