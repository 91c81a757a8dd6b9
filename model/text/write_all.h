#pragma once

#include <string_view>

namespace model {

/// Writes all bytes to an open file, also in several goes. False after a failure; errno says why.
[[nodiscard]] bool writeAll(int file, std::string_view bytes);

}  // namespace model
