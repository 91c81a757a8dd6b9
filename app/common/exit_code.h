#pragma once

#include "model/base/result.h"

namespace app {

/// What the process returns (docs/command-line.md).
enum ExitCode : int { kDone = 0, kWrongUsage = 1, kBadInput = 2, kFailed = 3, kTooClose = 4 };

/// Prints the error to stderr and says which code it means.
int fail(const base::Error& error);

/// To be asked last: what is still on its way to stdout gets there, and `code` is returned. Where it does not (a full
/// disk), that is said on stderr, and a code that speaks of success becomes kFailed.
[[nodiscard]] int endOutput(int code);

/// What a command returns: a code, or the error that is printed.
using Outcome = base::Result<int>;

}  // namespace app
