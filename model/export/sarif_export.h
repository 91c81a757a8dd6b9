#pragma once

#include "model/export/clearance_export.h"

namespace model {

/// SARIF 2.1.0, the form in which checkers report to code hosts: rules, and a result for each location, `most` of a
/// rule at most, with step, layer and nets as logical locations and the job as the file. Waived locations are
/// suppressed with the reason. What could not be checked is a result of the kind "open", a rule that passes one of the
/// kind "pass".
[[nodiscard]] std::string sarifReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                                      const ReportContext& context);

}  // namespace model
