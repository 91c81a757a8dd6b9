#pragma once

#include <string_view>

namespace model {

/// Does all of a name fit a pattern with * for any text and ? for any letter? The others count as they are.
[[nodiscard]] bool fitsWildcard(std::string_view name, std::string_view pattern);
/// The same where a letter of the name, given first, may be alike one of the pattern.
[[nodiscard]] bool fitsWildcard(std::string_view name, std::string_view pattern, bool (*isAlike)(char, char));

}  // namespace model
