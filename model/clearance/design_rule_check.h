#pragma once

#include "model/base/progress.h"
#include "model/clearance/design_rules.h"
#include "model/geometry/edges.h"

namespace model {

/// A location where a rule is broken.
struct RuleFinding {
    std::size_t rule = 0;  ///< row of RuleTable::rules
    LayerId layer;         ///< the first one where this is so
    ElementId a;
    ElementId b;      ///< none for the edge of the board
    Spacing spacing;  ///< nm; 0: they touch or overlap. Of a ring: from the hole's edge to the pad's
};

/// What lies on one side of a location: the name of its net, "(no net)", or for no element "(board edge)".
[[nodiscard]] std::string sideOf(const Document& step, ElementId element);

struct RuleReport {
    std::vector<RuleFinding> findings;  ///< by rule, then smallest first
    std::vector<std::size_t> counts;    ///< of findings by rule
    std::vector<std::string> notes;     ///< what was not checked, in plain words
    [[nodiscard]] bool isPassed() const { return findings.empty(); }
};

/// Checks a step's own elements against all rules; copies of other steps have a document of their own. One finding per
/// layer and pair: of nets for copper, of elements for everything else. The result does not depend on the number of
/// threads. Rules that are off find nothing. Errors: Cancelled.
[[nodiscard]] base::Result<RuleReport> checkRules(const Document& document, const RuleTable& table,
                                                  base::Progress& progress);

}  // namespace model
