#pragma once

#include "app/clearance/clearance_command.h"

namespace app {

struct ThroughStackup {
    std::string report;
    int code = kDone;  ///< kTooClose if --below was given and anything is closer
};

/// `copperscope clearance BOARD --through [--nets A,B] [--below LENGTH]`: the smallest distances between nets in space,
/// on panels across copies. Errors: BadUsage for a net that no step has.
[[nodiscard]] base::Result<ThroughStackup> runThroughStackup(const ClearanceArguments& arguments,
                                                             const model::Document& board, base::Progress& progress);

}  // namespace app
