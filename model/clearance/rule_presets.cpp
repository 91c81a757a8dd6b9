#include "model/clearance/rule_presets.h"

#include <algorithm>

namespace model {

std::string titleOf(const RulePreset& preset) {
    const std::string_view text = preset.text;
    const std::size_t begin = std::min(text.find_first_not_of("/ "), text.size());
    return std::string(text.substr(begin, text.find_first_of(".\n", begin) - begin));
}

const RulePreset* findPreset(std::string_view name) {
    const auto presets = rulePresets();
    const auto found = std::ranges::find_if(presets, [&](const RulePreset& preset) { return name == preset.name; });
    return found == presets.end() ? nullptr : &*found;
}

}  // namespace model
