#pragma once

#include "model/clearance/stackup_clearance.h"
#include "model/export/clearance_export.h"
#include "ui/clearance/clearance_model.h"
#include "ui/clearance/rule_model.h"

namespace ui {

/// What is looked for: the smallest clearances, or where rules are broken.
struct ClearanceRequest {
    bool isOfRules = false;
    model::ClearanceRequest question;                                ///< of the smallest clearances
    std::optional<model::StackupClearanceRequest> throughStackup{};  ///< instead of the smallest clearances
    model::RuleTable rules{};
    std::size_t leftOut = 0;  ///< entries of the file of rules that no rule checks
    std::vector<model::Waiver> waivers{};
};

/// Of every step what was asked for; steps are those of the board that was searched.
struct ClearanceResult {
    std::vector<model::StepClearances> clearances;
    std::vector<model::StepRules> rules;
    std::size_t leftOut = 0;  ///< as requested; 0 if no rules were checked
    bool isCut = false;       ///< no more than the request's count was looked for, and there may be more
    std::vector<model::StackupClearance> throughStackup;
    std::vector<std::shared_ptr<const model::SideNames>> names;  ///< of the steps of the one that is not empty; through
                                                                 ///< the stackup those of StepTree::steps
    std::vector<std::string> notes;  ///< what was not measured or checked, and what is good to know, in plain words
};
[[nodiscard]] std::vector<StepSpacings> spacingsOf(const ClearanceResult& answer);
/// By rule of the table, over all steps; empty if no rules were checked.
[[nodiscard]] std::vector<RuleResult> resultsOf(const model::RuleTable& rules, const ClearanceResult& answer);
/// Rows of ClearanceRequest::waivers without a finding.
[[nodiscard]] std::vector<std::size_t> goneWaivers(const ClearanceResult& answer);
/// Could every rule check everything, and was nothing left out of the rules?
[[nodiscard]] bool isComplete(const ClearanceResult& answer);

/// Looks for the smallest clearances of a board and all its steps, or through its stackup. Layers and nets in the
/// request are the board's own; placed steps are searched only when neither is named. Errors: those of
/// model::smallestClearances, model::smallestThroughStackup and model::checkRules.
[[nodiscard]] base::Result<ClearanceResult> searchClearances(const model::Document& board,
                                                             const ClearanceRequest& request, base::Progress& progress);

}  // namespace ui
