#pragma once

#include <cstdint>

namespace app {

/// Bounds what the process may allocate (its private data; memory that a graphics driver maps is not among it): beyond,
/// allocations fail, and what a board asks for ends with a message instead of driving the machine into the ground.
/// In builds with sanitizers, which map far more than there is, it does nothing.
void limitMemory(std::uint64_t bytes);

/// All that the machine has, in bytes.
[[nodiscard]] std::uint64_t machineMemory();

/// Says on stderr that memory ran out, and what sets the limit; returns kFailed.
int failOutOfMemory();

/// Where nobody catches it, in whatever thread, running out of memory ends the process with that message and code, and
/// not as a crash.
void endWhereMemoryRunsOut();

}  // namespace app
