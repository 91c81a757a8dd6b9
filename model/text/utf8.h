#pragma once

#include <cstddef>
#include <string_view>

namespace model {

/// Length in bytes of the UTF-8 sequence that a text begins with, which is not empty; 0 if it begins with none.
[[nodiscard]] std::size_t utf8Length(std::string_view text);
[[nodiscard]] bool isUtf8(std::string_view text);

}  // namespace model
