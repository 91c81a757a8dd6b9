#pragma once

#include <span>
#include <string>

#include "targets.h"

namespace fuzz {

/// A tar archive (V7 dialect) of these files. Paths longer than the format's 100 bytes are cut.
[[nodiscard]] std::string writeTar(std::span<const File> files);

}  // namespace fuzz
