#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>

namespace model::gerber {

/// $1, $2 …; those that nobody set are 0.
using MacroVariables = std::unordered_map<int, double>;

/// The value of an arithmetic expression of an aperture macro: numbers, variables, + - x X / and parentheses. No
/// blanks. Nothing if it cannot be read or has no finite value.
[[nodiscard]] std::optional<double> evaluate(std::string_view expression, const MacroVariables& variables);

}  // namespace model::gerber
