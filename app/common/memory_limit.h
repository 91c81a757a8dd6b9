#pragma once

#include <cstdint>

#include "model/base/result.h"

namespace app {

/// Bounds what the process may allocate (its private data; memory that a graphics driver maps is not among it): beyond,
/// allocations fail, and what a board asks for ends with a message instead of driving the machine into the ground.
/// In builds with sanitizers, which map far more than there is, it does nothing.
void limitMemory(std::uint64_t bytes);

/// All that the machine has, in bytes.
[[nodiscard]] std::uint64_t machineMemory();

/// May less be taken than the machine has?
[[nodiscard]] bool isMemoryLimited();

/// To be asked before a Vulkan device is opened: a software device compiles its programs while it draws, and that
/// compiler ends the process where it finds no memory, without a word.
/// Errors: DeviceFailed where the limit leaves less than such a device was seen to take, with a margin.
[[nodiscard]] base::Status checkRoomForDevice();

/// Says on stderr that memory ran out, and what sets the limit; returns kFailed.
int failOutOfMemory();

/// Where nobody catches it, in whatever thread, running out of memory ends the process with that message and code, and
/// not as a crash.
void endWhereMemoryRunsOut();

}  // namespace app
