#include "ui/clearance/clearance_search.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace ui {

namespace {

using base::Result;
using model::Document;

bool isOfTheBoardAlone(const model::ClearanceRequest& question) {
    return question.layer.isValid() || question.between.first.isValid() || question.within.has_value();
}

base::Status checkRules(const Document& step, const ClearanceRequest& request, base::Progress& progress,
                        ClearanceResult& answer) {
    ASSIGN_OR_RETURN(model::RuleReport report, model::checkRules(step, request.rules, progress));
    for (const std::string& note : report.notes) {
        answer.notes.push_back("step " + step.job.step + ": " + note);
    }
    answer.rules.push_back({&step, std::move(report)});
    return base::Done{};
}

/// Without nets there is nothing to measure.
base::Status measure(const Document& step, const ClearanceRequest& request, base::Progress& progress,
                     ClearanceResult& answer) {
    if (step.nets.empty()) {
        return base::Done{};
    }
    ASSIGN_OR_RETURN(std::vector<model::Clearance> clearances,
                     model::smallestClearances(step, request.question, progress));
    answer.clearances.push_back({&step, std::move(clearances)});
    return base::Done{};
}

}  // namespace

Result<ClearanceResult> searchClearances(const Document& board, const ClearanceRequest& request,
                                         base::Progress& progress) {
    ClearanceResult answer;
    const bool isOfBoard = !request.isOfRules && isOfTheBoardAlone(request.question);
    for (const Document* step : isOfBoard ? std::vector{&board} : model::distinctSteps(board)) {
        RETURN_IF_ERROR(request.isOfRules ? checkRules(*step, request, progress, answer)
                                          : measure(*step, request, progress, answer));
    }
    if (!request.isOfRules) {
        answer.notes = model::unmeasuredSteps(board);
    }
    return answer;
}

std::vector<StepSpacings> spacingsOf(const ClearanceResult& answer) {
    std::vector<StepSpacings> gaps;
    for (const model::StepRules& step : answer.rules) {
        gaps.push_back({step.step, step.report.findings});
    }
    for (const model::StepClearances& step : answer.clearances) {
        gaps.push_back({step.step, {}});
        for (const model::Clearance& c : step.clearances) {
            gaps.back().locations.push_back({0, c.layer, c.a, c.b, c.spacing});
        }
    }
    return gaps;
}

std::vector<std::size_t> countsOf(const ClearanceResult& answer) {
    std::vector<std::size_t> counts;
    for (const model::StepRules& step : answer.rules) {
        counts.resize(step.report.counts.size());
        std::ranges::transform(counts, step.report.counts, counts.begin(), std::plus());
    }
    return counts;
}

}  // namespace ui
