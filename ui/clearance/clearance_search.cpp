#include "ui/clearance/clearance_search.h"

#include <algorithm>
#include <utility>

#include "model/design_rules/waived_check.h"

namespace ui {

namespace {

using base::Result;
using model::Document;

bool isOfTheBoardAlone(const model::ClearanceRequest& question) {
    return question.layer.isValid() || question.between.first.isValid() || question.within.has_value();
}

base::Status checkRules(const Document& step, const ClearanceRequest& request, base::Progress& progress,
                        ClearanceResult& answer) {
    ASSIGN_OR_RETURN(model::RuleReport report, model::checkRules(step, request.rules, request.waivers, progress));
    const std::string start = "step " + step.job.step + ": ";
    for (const model::Unchecked& unchecked : report.unchecked) {
        answer.notes.push_back(start + "not checked: " + model::titleOf(request.rules.rules[unchecked.rule]) + ": " +
                               model::textOf(unchecked));
    }
    for (const model::WaiverNote& note : report.waiverNotes) {
        answer.notes.push_back(start + note.text);
    }
    for (const model::NetTie& tie : report.netTies) {
        answer.notes.push_back(start + "net tie: " + model::textOf(step, tie));
    }
    for (const std::string& note : report.notes) {
        answer.notes.push_back(start + note);
    }
    answer.rules.push_back({&step, std::move(report)});
    answer.names.push_back(std::make_shared<const model::SideNames>(step));
    return base::Done{};
}

/// First of all notes: rules that pass say nothing of it.
void noteLeftOut(const ClearanceRequest& request, ClearanceResult& answer) {
    answer.leftOut = request.isOfRules ? request.leftOut : 0;
    if (answer.leftOut > 0) {
        answer.notes.push_back("not checked: " + std::to_string(answer.leftOut) +
                               (answer.leftOut == 1 ? " entry" : " entries") +
                               " of the file of rules without a counterpart here; Messages lists them");
    }
}

/// Without nets there is nothing to measure.
base::Status measure(const Document& step, const ClearanceRequest& request, base::Progress& progress,
                     ClearanceResult& answer) {
    if (step.nets.empty()) {
        return base::Done{};
    }
    ASSIGN_OR_RETURN(std::vector<model::Clearance> clearances,
                     model::smallestClearances(step, request.question, progress));
    answer.isCut = answer.isCut || clearances.size() == request.question.count;
    answer.clearances.push_back({&step, std::move(clearances)});
    answer.names.push_back(std::make_shared<const model::SideNames>(step));
    return base::Done{};
}

Result<ClearanceResult> measureThrough(const Document& board, const model::StackupClearanceRequest& request,
                                       base::Progress& progress) {
    ClearanceResult answer;
    ASSIGN_OR_RETURN(answer.throughStackup, model::smallestThroughStackup(board, request, progress));
    answer.isCut = answer.throughStackup.size() == request.count;
    for (const Document* step : model::unfoldCopies(board).steps) {
        answer.names.push_back(std::make_shared<const model::SideNames>(*step));
    }
    return answer;
}

}  // namespace

Result<ClearanceResult> searchClearances(const Document& board, const ClearanceRequest& request,
                                         base::Progress& progress) {
    if (request.throughStackup) {
        return measureThrough(board, *request.throughStackup, progress);
    }
    ClearanceResult answer;
    noteLeftOut(request, answer);
    const bool isOfBoard = !request.isOfRules && isOfTheBoardAlone(request.question);
    for (const Document* step : isOfBoard ? std::vector{&board} : model::distinctSteps(board)) {
        RETURN_IF_ERROR(request.isOfRules ? checkRules(*step, request, progress, answer)
                                          : measure(*step, request, progress, answer));
    }
    if (!request.isOfRules) {
        answer.notes = model::unmeasuredSteps(board);
    }
    for (model::WaiverNote& note : model::waiversElsewhere(request.waivers, model::distinctSteps(board))) {
        if (request.isOfRules) {
            answer.notes.push_back(note.text);
            answer.rules.front().report.waiverNotes.push_back(std::move(note));
        }
    }
    return answer;
}

std::vector<StepSpacings> spacingsOf(const ClearanceResult& answer) {
    std::vector<StepSpacings> found;
    for (const model::StepRules& step : answer.rules) {
        found.push_back({step.step, step.report.findings, answer.names[found.size()], step.report.waived});
    }
    for (const model::StepClearances& step : answer.clearances) {
        found.push_back({step.step, {}, answer.names[found.size()]});
        for (const model::Clearance& c : step.clearances) {
            found.back().locations.push_back({0, c.layer, c.a, c.b, c.spacing});
        }
    }
    return found;
}

std::vector<RuleResult> resultsOf(const model::RuleTable& rules, const ClearanceResult& answer) {
    std::vector<RuleResult> results(answer.rules.empty() ? 0 : rules.rules.size());
    for (const model::StepRules& step : answer.rules) {
        for (std::size_t rule = 0; rule < results.size(); ++rule) {
            RuleResult& result = results[rule];
            result.verdict = std::max(result.verdict, model::verdictOf(rules, step.report, rule));
            result.count += step.report.counts[rule];
            result.waived += model::waivedOf(step.report, rule);
            result.unchecked +=
                static_cast<std::size_t>(std::ranges::count(step.report.unchecked, rule, &model::Unchecked::rule));
        }
    }
    return results;
}

std::vector<std::size_t> goneWaivers(const ClearanceResult& answer) {
    std::vector<std::size_t> rows;
    for (const model::StepRules& step : answer.rules) {
        for (const model::WaiverNote& note : step.report.waiverNotes) {
            if (note.state == model::WaiverNote::State::Gone) {
                rows.push_back(note.waiver);
            }
        }
    }
    return rows;
}

bool isComplete(const ClearanceResult& answer) {
    return answer.leftOut == 0 &&
           std::ranges::all_of(answer.rules, [](const model::StepRules& step) { return step.report.isComplete(); });
}

}  // namespace ui
