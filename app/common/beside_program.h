#pragma once

#include <filesystem>

namespace app {

/// A file that is installed with the program: `relative` is the way to it from the folder of the program.
[[nodiscard]] std::filesystem::path besideProgram(const std::filesystem::path& relative);

}  // namespace app
