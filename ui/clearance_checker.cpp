#include "ui/clearance_checker.h"

#include <new>
#include <utility>

namespace ui {

namespace {

using base::Result;
using model::Document;

Result<std::vector<model::RuleFinding>> narrowest(const Document& step, const ClearanceRequest& request,
                                                  base::Progress& progress) {
    const Result<std::vector<model::Clearance>> clearances =
        model::narrowestClearances(step, request.question, progress);
    if (!clearances) {
        return clearances.error();
    }
    std::vector<model::RuleFinding> places;
    for (const model::Clearance& c : *clearances) {
        places.push_back({0, c.layer, c.a, c.b, c.gap});
    }
    return places;
}

Result<std::vector<model::RuleFinding>> broken(const Document& step, const ClearanceRequest& request,
                                               base::Progress& progress, ClearanceAnswer& answer) {
    Result<model::RuleReport> report = model::checkRules(step, request.rules, progress);
    if (!report) {
        return report.error();
    }
    for (std::size_t rule = 0; rule < report->counts.size(); ++rule) {
        answer.counts[rule] += report->counts[rule];
    }
    for (const std::string& remark : report->remarks) {
        answer.remarks.push_back("Step " + step.job.step + ": " + remark);
    }
    return std::move(report->findings);
}

bool isOfTheBoardAlone(const model::ClearanceQuestion& question) {
    return question.layer.isValid() || question.between.first.isValid() || question.within.has_value();
}

Result<ClearanceAnswer> search(const Document& board, const ClearanceRequest& request, base::Progress& progress) {
    ClearanceAnswer answer;
    answer.counts.resize(request.isOfRules ? request.rules.rules.size() : 0);
    const std::vector<const Document*> steps = model::distinctSteps(board);
    const std::size_t count = !request.isOfRules && isOfTheBoardAlone(request.question) ? 1 : steps.size();
    for (std::uint32_t step = 0; step < count; ++step) {
        Result<std::vector<model::RuleFinding>> places = request.isOfRules
                                                             ? broken(*steps[step], request, progress, answer)
                                                             : narrowest(*steps[step], request, progress);
        if (!places) {
            return places.error();
        }
        answer.gaps.push_back({step, std::move(*places)});
    }
    return answer;
}

}  // namespace

ClearanceChecker::ClearanceChecker(QObject* parent) : QObject(parent) {
    connect(&m_background, &Background::progressed, this, &ClearanceChecker::progressed);
    connect(&m_background, &Background::finished, this, &ClearanceChecker::deliver);
}

void ClearanceChecker::start(std::shared_ptr<const Document> board, ClearanceRequest request) {
    m_board = std::move(board);
    m_request = std::move(request);
    m_outcome = std::make_shared<Outcome>();
    m_background.start(
        [board = m_board, request = m_request, outcome = m_outcome](base::Progress& progress) {
            try {
                *outcome = search(*board, request, progress);
            } catch (const std::bad_alloc&) {
                *outcome = base::Error{base::ErrorCode::BadInput, "There is not enough memory to measure clearances"};
            }
        },
        "Measuring clearances");
}

void ClearanceChecker::deliver() {
    const std::shared_ptr<Outcome> outcome = std::move(m_outcome);
    if (**outcome) {
        emit found(m_board, m_request, ***outcome);
    } else {
        emit failed(QString::fromStdString((*outcome)->error().text));
    }
}

}  // namespace ui
