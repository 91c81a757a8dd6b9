#pragma once

#include <nlohmann/json.hpp>

#include "model/board/document.h"

namespace app {

/// `drills` of `info --json`: a row per layer, kind and size: {"layer", "add_type", "from", "to", "span", "kind",
/// "plated", "shape", "diameter_nm", "open_nm", "tool", "process", "bit", "finished_nm", "drill_nm", "count"}. `tool`
/// and what comes from it are null where no tool of the layer fits or the job does not say.
[[nodiscard]] nlohmann::ordered_json drillsJson(const model::Document& document);

/// The same as a table on stdout; nothing for a board without holes.
void printDrills(const model::Document& document);

}  // namespace app
