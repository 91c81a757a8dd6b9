#pragma once

#include "app/commands/clearance_command.h"

namespace app {

/// `copperscope clearance BOARD --through [--nets A,B] [--below LENGTH]`: the smallest distances between nets in space,
/// on panels across copies, on stdout. Errors: BadUsage with --rules or --layer, or for a net that no step has.
/// kTooClose if --below was given and anything is closer.
[[nodiscard]] Outcome runThroughStackup(const ClearanceArguments& arguments, const model::Document& board,
                                        base::Progress& progress);

}  // namespace app
