#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "ui/shell/interaction_bench.h"

namespace app {

struct InteractionArguments {
    std::vector<std::string> boards;
    ui::InteractionRequest request;  ///< its board has no path
    bool asJson = false;
};

/// `copperscope bench --interactive BOARD…`: how fast the window answers the hand, one table per board.
[[nodiscard]] Outcome runInteractionBench(const InteractionArguments& arguments);

}  // namespace app
