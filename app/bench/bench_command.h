#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct BenchArguments {
    std::vector<std::string> boards;
    BoardArguments modelling;       ///< step and chords; its path is not used
    std::string pipeline = "both";  ///< or "hybrid", "standard"
    std::string levels = "error";   ///< of detail; or "paper", "coarse"
    bool onlyCulled = false;        ///< leaves out frames without culling and level of detail
    bool hasComponents = false;     ///< with the bodies of the components
    int frames = 7;                 ///< per median
    bool hasStages = false;         ///< times the stages of frames too
    bool asJson = false;
};

/// `copperscope bench BOARD…`: the paper's Tables 2, 4 and 5 for these boards on this device.
[[nodiscard]] Outcome runBench(const BenchArguments& arguments);

}  // namespace app
