#pragma once

#include "app/common/open_board.h"

namespace app {

struct InfoArguments {
    BoardArguments board;
    bool asJson = false;
    bool checkNets = false;
};

/// `copperscope info BOARD [--json] [--check-nets]`: what is in the job, on stdout. Returns an exit code.
int runInfo(const InfoArguments& arguments);

}  // namespace app
