#pragma once

#include "model/export/clearance_export.h"

namespace model {

/// One page of HTML (also well-formed XML) that needs nothing beside it: what every rule says, and for each location,
/// `most` of a rule at most, its sides and a drawing of the place (LocationPictures); waived ones with their reasons.
[[nodiscard]] std::string htmlReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                                     const ReportContext& context);

}  // namespace model
