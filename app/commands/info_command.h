#pragma once

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct InfoArguments {
    BoardArguments board;
    bool asJson = false;
    bool checkNets = false;
    bool allowsIncomplete = false;  ///< the check of nets also passes where not all of the job could be read
    bool printsLayerMap = false;
};

/// `copperscope info BOARD [--json] [--check-nets]`: what is in the job, on stdout. With `--print-layer-map` instead
/// what the files of a Gerber job are taken to draw, as a layer map.
[[nodiscard]] Outcome runInfo(const InfoArguments& arguments);

}  // namespace app
