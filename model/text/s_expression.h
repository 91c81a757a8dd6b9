#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace model {

/// A list in parentheses, or an atom: (rule "power" (constraint clearance (min 0.2mm))).
struct SExpression {
    std::string atom;  ///< of an atom, without quotes
    bool isList = false;
    std::vector<SExpression> items;  ///< of a list
    std::size_t line = 0;            ///< 1-based, where it begins

    /// The word a list begins with; empty if it does not begin with one.
    [[nodiscard]] const std::string& head() const;
    /// The first list inside that begins with a word; nullptr if there is none.
    [[nodiscard]] const SExpression* find(std::string_view head) const;
    /// The atom at a place of a list; empty if there is none.
    [[nodiscard]] const std::string& at(std::size_t index) const;
};

/// All of a text, as the items of one list. Comments run from # at the beginning of a word to the end of the line.
/// Errors: BadInput, with the line: lists or texts that do not end, or are nested deeper than base::kMostListDepth.
[[nodiscard]] base::Result<SExpression> parseSExpressions(std::string_view text);

}  // namespace model
