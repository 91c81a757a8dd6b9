#pragma once

#include <nlohmann/json.hpp>

#include "app/open_board.h"

namespace app {

/// The report of `info --json`. Keys are lower_snake_case and stable; lengths carry their unit in the key.
[[nodiscard]] nlohmann::ordered_json infoJson(const OpenBoard& board);

/// Holes of one diameter and plating on one drill layer.
struct DrillRow {
    std::uint32_t layer = 0;
    model::Nm diameter = 0;  ///< 0 for slots and routed paths
    bool isPlated = false;
    std::uint32_t count = 0;
};

/// The holes of all drill and rout layers, by layer, diameter and plating.
[[nodiscard]] std::vector<DrillRow> drillRows(const model::Document& document);

}  // namespace app
