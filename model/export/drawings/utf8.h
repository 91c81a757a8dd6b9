#pragma once

#include <cstdint>
#include <string_view>

namespace model {

struct Character {
    std::uint32_t code = 0;  ///< of Unicode; 0: the bytes are no UTF-8
    std::size_t bytes = 1;
};

/// The first character of a text that is not empty.
[[nodiscard]] Character firstCharacter(std::string_view utf8);

}  // namespace model
