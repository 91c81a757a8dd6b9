#pragma once

#include <filesystem>

namespace app {

/// The board that comes with Copperscope: beside an installed program (../share/copperscope), else in the source tree
/// it was built from.
[[nodiscard]] std::filesystem::path sampleBoard();

}  // namespace app
