#pragma once

#include <string>
#include <vector>

#include "model/clearance/rule_check.h"

namespace app {

/// What the rules say of one step.
struct StepRules {
    const model::Document* step = nullptr;
    model::RuleReport report;
};

/// Prints every rule with pass or fail and its places, `most` of each at most, on stdout; what was not checked goes to
/// stderr. `format`: text, json or csv.
void printRules(const model::RuleTable& table, const std::vector<StepRules>& steps, const std::string& format,
                std::size_t most);

}  // namespace app
