#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace model {

/// One term of a condition of KiCad's custom rules: "A.Type == 'Via'", "!B.isPlated()", "A.Net != B.Net".
struct ConditionTerm {
    bool isNegated = false;  ///< "!" before it, or "!="
    std::size_t side = 0;    ///< 0: of A, 1: of B
    std::string name;        ///< of a property, or of a function with "()"
    std::string text;        ///< what the property is compared with, or what the function is given
    std::string other;       ///< the property of the other side that it is compared with instead
};

/// Terms that hold together.
using ConditionTerms = std::vector<ConditionTerm>;

inline constexpr std::size_t kMostAlternatives = 32;
inline constexpr int kMostConditionDepth = 16;

/// A condition as alternatives. None for what it is made of otherwise: other operators, numbers, "!" before
/// parentheses, more alternatives than kMostAlternatives, or parentheses deeper than kMostConditionDepth.
[[nodiscard]] std::optional<std::vector<ConditionTerms>> parseKicadCondition(std::string_view text);

}  // namespace model
