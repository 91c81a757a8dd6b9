#include "ui/clearance/clearance_checker.h"

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
    Result<model::RuleReport> report = model::checkRules(step, request.rules, progress);
    if (!report) {
        return report.error();
    }
    for (const std::string& note : report->notes) {
        answer.notes.push_back("step " + step.job.step + ": " + note);
    }
    answer.rules.push_back({&step, std::move(*report)});
    return base::Done{};
}

/// Without nets there is nothing to measure.
base::Status measure(const Document& step, const ClearanceRequest& request, base::Progress& progress,
                     ClearanceResult& answer) {
    if (step.nets.empty()) {
        return base::Done{};
    }
    Result<std::vector<model::Clearance>> clearances = model::smallestClearances(step, request.question, progress);
    if (!clearances) {
        return clearances.error();
    }
    answer.clearances.push_back({&step, std::move(*clearances)});
    return base::Done{};
}

Result<ClearanceResult> search(const Document& board, const ClearanceRequest& request, base::Progress& progress) {
    ClearanceResult answer;
    const bool isOfBoard = !request.isOfRules && isOfTheBoardAlone(request.question);
    for (const Document* step : isOfBoard ? std::vector{&board} : model::distinctSteps(board)) {
        const base::Status done = request.isOfRules ? checkRules(*step, request, progress, answer)
                                                    : measure(*step, request, progress, answer);
        if (!done) {
            return done.error();
        }
    }
    if (!request.isOfRules) {
        answer.notes = model::unmeasuredSteps(board);
    }
    return answer;
}

}  // namespace

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

ClearanceChecker::ClearanceChecker(QObject* parent) : QObject(parent) {
    connect(&m_search.background(), &Background::finished, this, &ClearanceChecker::deliver);
}

void ClearanceChecker::start(std::shared_ptr<const Document> board, ClearanceRequest request) {
    m_board = std::move(board);
    m_request = std::move(request);
    m_search.run(
        [board = m_board, request = m_request](base::Progress& progress) { return search(*board, request, progress); },
        tr("Measuring clearances"), tr("There is not enough memory to measure clearances"));
}

void ClearanceChecker::deliver() {
    if (const auto answer = m_search.take()) {
        emit found(m_board, m_request, *answer);
    } else {
        emit failed(QString::fromStdString(answer.error().text));
    }
}

}  // namespace ui
