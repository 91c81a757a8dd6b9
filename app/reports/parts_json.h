#pragma once

#include <nlohmann/json.hpp>

#include "model/board/document.h"
#include "model/nets/net_check.h"

namespace app {

/// `nets{count, list[{name, elements, pins, vias}]}` of `info --json`.
[[nodiscard]] nlohmann::ordered_json netsJson(const model::Document& document);
/// `components{count, list[…]}`. `mounting_layer` of a component is the inner layer that it stands on (rigid-flex),
/// else null; `in_bom` is as model::isInBom says.
[[nodiscard]] nlohmann::ordered_json componentsJson(const model::Document& document);

/// `connectivity{islands, opens[], loose[], shorts[]}`.
[[nodiscard]] nlohmann::ordered_json connectivityJson(const std::vector<model::StepCheck>& checks);
void printConnectivity(const std::vector<model::StepCheck>& checks);

}  // namespace app
