#pragma once

namespace base {

/// From now on this thread, and those it makes, work in the time that others leave over. Where the system does not let
/// them they work as before.
void becomeBackground();

}  // namespace base
