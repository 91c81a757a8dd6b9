#pragma once

#include <optional>
#include <vector>

#include "model/base/progress.h"
#include "model/clearance/copper_owners.h"
#include "model/clearance/layer_geometry.h"
#include "model/clearance/rule_choice.h"
#include "model/clearance/rule_report.h"
#include "model/design_rules/design_rule_check.h"

namespace model {

/// Rules of a kind that one search for closest pairs is for: those that name no objects (none), or one that does. Of
/// two nets on a layer all pairs of a search then fall under one rule, and no closer pair that another rule lets pass
/// hides one that breaks it.
using RuleSearch = std::optional<std::size_t>;

/// What all checks of rules share: the board, which rule holds for what, and where findings go. A check of a kind is a
/// function that takes it (copper_spacings.h, mask_checks.h, …).
class RuleContext {
public:
    RuleContext(const Document& document, const RuleTable& table, const RuleScope& scope, const CopperNets& nets,
                base::Progress& progress);

    [[nodiscard]] const Document& document() const { return m_document; }
    [[nodiscard]] const RuleTable& table() const { return m_table; }
    [[nodiscard]] const RuleChoice& choice() const { return m_choice; }
    [[nodiscard]] const CopperOwners& owners() const { return m_nets.owners; }
    [[nodiscard]] const CopperNets& nets() const { return m_nets; }
    [[nodiscard]] const std::vector<HoleClass>& holeClasses() const { return m_holes; }
    [[nodiscard]] base::Progress& progress() const { return m_progress; }
    [[nodiscard]] RuleReport& report() { return m_report; }

    /// Why the scope leaves out rules of a kind; empty if it does not.
    [[nodiscard]] std::string whyBeyond(RuleKind kind) const;
    /// The same of a rule, whose layers the step may lack.
    [[nodiscard]] std::string whyBeyond(std::size_t rule) const;
    /// Is there a rule of the kind for a layer, in the scope?
    [[nodiscard]] bool isWanted(RuleKind kind, LayerId layer) const;
    /// Is the layer in the scope?
    [[nodiscard]] bool isWanted(LayerId layer) const { return !m_scope.layer.isValid() || m_scope.layer == layer; }
    /// Are they of the two nets of the scope, if it names any?
    [[nodiscard]] bool isBetween(ElementId a, ElementId b) const;
    /// The searches of a kind; a single one where no rule names objects.
    [[nodiscard]] std::vector<RuleSearch> searchesOf(RuleKind kind) const;
    /// RuleChoice::of, if it is a rule of the search.
    [[nodiscard]] std::optional<std::size_t> ruleOf(RuleSearch search, RuleKind kind, LayerId layer, const RuleParty& a,
                                                    const RuleParty& b = {}) const;
    [[nodiscard]] bool isOfAllNets() const { return m_scope.between == std::pair<NetId, NetId>(); }
    [[nodiscard]] const RuleScope& scope() const { return m_scope; }
    [[nodiscard]] LayerId scopeLayer() const { return m_scope.layer; }

    [[nodiscard]] NetId netOf(ElementId element) const { return m_nets.netOf(element); }
    [[nodiscard]] CopperObject objectOf(ElementId element) const { return m_objects[element.row()]; }
    /// An element as one side of a rule.
    [[nodiscard]] RuleParty partyOf(ElementId element) const {
        return {netOf(element), m_holes[element.row()], m_objects[element.row()]};
    }
    /// Pads and holes: what has no net and is none of them is text, a shape or a part of one.
    [[nodiscard]] bool isLand(ElementId element) const {
        return (m_document.elements.flags[element.row()] & (kPad | kHole)) != 0;
    }
    /// By element: is it a stroke of a text? Found out when it is first asked for.
    [[nodiscard]] const std::vector<bool>& textStrokes();
    /// Does an NPTH take the element away?
    [[nodiscard]] bool isAway(ElementId element) const { return m_isAway[element.row()]; }
    [[nodiscard]] std::size_t awayCount() const;
    /// Copper that no NPTH takes away.
    [[nodiscard]] ElementFilter isThere() const {
        return [this](ElementId element) { return !isAway(element); };
    }

    /// A finding if the spacing breaks the rule.
    void add(std::size_t rule, LayerId layer, ElementId a, ElementId b, const Spacing& spacing,
             FindingReason reason = FindingReason::TooClose);
    void addIfBroken(const RuleFinding& finding);
    void add(RuleFinding finding) { m_report.findings.push_back(finding); }

private:
    const Document& m_document;
    const RuleTable& m_table;
    const RuleScope& m_scope;
    const CopperNets& m_nets;
    RuleChoice m_choice;
    std::vector<bool> m_isAway;           ///< elements that NPTHs take away
    std::vector<HoleClass> m_holes;       ///< by element
    std::vector<CopperObject> m_objects;  ///< by element
    std::vector<bool> m_textStrokes;      ///< by element, once it was asked for
    base::Progress& m_progress;
    RuleReport m_report;
};

/// A layer of solder mask as the job has it, with its openings.
[[nodiscard]] inline bool isMask(const Layer& layer) {
    return layer.type == LayerType::SolderMask && !layer.isSynthetic;
}

}  // namespace model
