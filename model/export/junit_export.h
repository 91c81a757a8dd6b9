#pragma once

#include "model/export/clearance_export.h"

namespace model {

/// XML as JUnit writes it, which most build servers show: a test suite for each rule and step, in it a failed test for
/// each location, `most` at most and one for the others, an error for all that could not be checked, a skipped test for
/// each waived location with its reason, and for a rule that is unused or off. A rule that passes is one test. Names of
/// tests hold no numbers of elements, so that a server knows them again in the next version of the board.
[[nodiscard]] std::string junitReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                                      const ReportContext& context);

}  // namespace model
