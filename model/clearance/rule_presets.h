#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/clearance/design_rules.h"

namespace model {

/// Rules that come with the program: files in resources/rules, which the build puts into it as they are.
struct RulePreset {
    const char* name;  ///< of the file, without ending: "prototype"
    const char* text;  ///< with comments; the first line is a title
};
[[nodiscard]] std::span<const RulePreset> rulePresets();
/// "Two and four layers at common prototype services"
[[nodiscard]] std::string titleOf(const RulePreset& preset);
/// nullptr if there is none.
[[nodiscard]] const RulePreset* findPreset(std::string_view name);

}  // namespace model
