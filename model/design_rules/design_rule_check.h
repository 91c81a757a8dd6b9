#pragma once

#include <functional>
#include <utility>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/clearance/rule_report.h"

namespace model {

/// What rules are held against; everything if nothing is named.
struct RuleScope {
    LayerId layer{};                    ///< only here; one that isRuled
    std::pair<NetId, NetId> between{};  ///< only between these two: rules that are not between nets are unused then
    /// Does somebody accept this location? Of two nets that have such locations on a layer all of them are findings,
    /// one for each pair of elements, and the closest of the others.
    std::function<bool(const RuleFinding&)> isAccepted{};
    /// May two nets have such locations, though their closest one is none? Called from any thread.
    std::function<bool(NetId, NetId)> mayBeAccepted{};
};

/// Is some kind of rule checked on a layer: copper, and solder mask and silkscreen of the job?
[[nodiscard]] bool isRuled(const Layer& layer);

/// Checks a step's own elements against all rules; copies of other steps have a document of their own. One finding per
/// layer and pair: of nets for copper, of elements for everything else; per hole for its size and depth, for a pad that
/// the drill removes, and for a hole without a pad. Copper without a net counts to the net that it touches
/// (CopperOwners); what touches none is held against nets, and where it is a pad or plated hole also against other such
/// copper. The result does not depend on the number of threads. Rules that are off find nothing. What a rule could not
/// be held against is counted in RuleReport::unchecked, with the reason. On a single layer, holes are not said to have
/// no pad. Errors: Cancelled.
[[nodiscard]] base::Result<RuleReport> checkRules(const Document& document, const RuleTable& table,
                                                  base::Progress& progress, const RuleScope& scope = {});

}  // namespace model
