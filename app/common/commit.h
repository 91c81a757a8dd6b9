#pragma once

namespace app {

/// What was built: the commit, with "+" after it when the source differed; empty outside of a git checkout.
extern const char* const kCommit;

}  // namespace app
