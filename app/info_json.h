#pragma once

#include <nlohmann/json.hpp>

#include "app/open_board.h"

namespace app {

/// The report of `info --json`. Keys are lower_snake_case and stable; lengths carry their unit in the key.
[[nodiscard]] nlohmann::ordered_json infoJson(const OpenBoard& board);

}  // namespace app
