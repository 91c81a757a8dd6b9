#pragma once

#include <string>

#include "app/manual/manual.h"

namespace app {

/// The page of `program` itself (copperscope.1), in the macros of man(7).
[[nodiscard]] std::string manPage(const ManualCommand& program, const std::string& version);

/// That of one of its commands (copperscope-info.1).
[[nodiscard]] std::string manPage(const ManualCommand& program, const ManualCommand& command,
                                  const std::string& version);

}  // namespace app
