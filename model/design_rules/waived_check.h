#pragma once

#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "model/base/progress.h"
#include "model/clearance/waivers.h"
#include "model/design_rules/design_rule_check.h"

namespace model {

/// Which waivers hold for findings of one step. A waiver holds for a finding of the same step, layer, kind of rule and
/// fault whose spacing has both ends within kWaiverReach of those of the waiver, either way round, or whose two
/// elements both pass there (two tracks side by side are closest in many locations), as long as no less is left than
/// when it was waived, give or take the tolerance of limits: of a hole that is too deep, as long as it is no deeper for
/// its width. Names of nets and pins do not count. All of it must outlive it.
class WaiverMatch {
public:
    WaiverMatch(const Document& step, const RuleTable& table, std::span<const Waiver> waivers);

    /// Row of the one that holds; the number of all if there is none.
    [[nodiscard]] std::size_t holderOf(const RuleFinding& finding) const;
    /// Is it the location of this waiver, whatever is left there?
    [[nodiscard]] bool isAt(std::size_t waiver, const RuleFinding& finding) const;
    /// Is less left than when it was waived?
    [[nodiscard]] bool isWorse(std::size_t waiver, const RuleFinding& finding) const;

private:
    using Rows = std::vector<std::size_t>;
    using Key = std::tuple<RuleKind, FindingReason, LayerId>;

    /// Where the second drill is, of two holes that may be waived on either's layer; else that of the finding.
    [[nodiscard]] LayerId otherLayerOf(const RuleFinding& finding) const;
    /// Of all waivers that may be at a finding.
    [[nodiscard]] Rows rowsFor(const RuleFinding& finding) const;

    const Document& m_step;
    const RuleTable& m_table;
    std::span<const Waiver> m_waivers;
    std::vector<LayerId> m_layers;  ///< by waiver
    std::map<Key, Rows> m_rows;     ///< of this step
};

/// checkRules, with findings that are waived apart from those that count, and what is to be said of the waivers of this
/// step: those of locations that are fine by now, and those that do not hold any more. Waivers beyond the scope are
/// left alone. Of two nets with a waived location on a layer every other location counts, up to one per pair of
/// elements.
[[nodiscard]] base::Result<RuleReport> checkRules(const Document& step, const RuleTable& table,
                                                  std::span<const Waiver> waivers, base::Progress& progress,
                                                  RuleScope scope = {});

/// Of waivers for steps that are not among these.
[[nodiscard]] std::vector<WaiverNote> waiversElsewhere(std::span<const Waiver> waivers,
                                                       std::span<const Document* const> steps);

}  // namespace model
