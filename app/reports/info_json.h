#pragma once

#include <nlohmann/json.hpp>

#include "app/common/open_board.h"
#include "app/reports/parts_json.h"

namespace app {

/// The report of `info --json`. Keys are lower_snake_case and stable; lengths carry their unit in the key. `checks` are
/// those of `--check-nets`, nullptr without.
[[nodiscard]] nlohmann::ordered_json infoJson(const CountedBoard& board, const std::vector<model::StepCheck>* checks);

/// A step that the board places, at whatever depth.
struct PlacedStep {
    const model::Document* step = nullptr;
    std::uint64_t copies = 0;  ///< all of them, those in copies of other steps included
};

/// Each step once; empty for a board that places none.
[[nodiscard]] std::vector<PlacedStep> placedSteps(const model::Document& document);

}  // namespace app
