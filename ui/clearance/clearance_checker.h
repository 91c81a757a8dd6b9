#pragma once

#include <QObject>
#include <memory>

#include "model/clearance/clearance_report.h"
#include "ui/clearance/clearance_model.h"
#include "ui/workspace/background_result.h"

namespace ui {

/// What is looked for: the narrowest places, or where rules are broken.
struct ClearanceRequest {
    bool isOfRules = false;
    model::ClearanceRequest question;  ///< of the narrowest places
    model::RuleTable rules;
};

/// Of every step what was asked for; steps are those of the board that was searched.
struct ClearanceResult {
    std::vector<model::StepClearances> clearances;
    std::vector<model::StepRules> rules;
    std::vector<std::string> notes;  ///< what was not measured, in plain words
};
[[nodiscard]] std::vector<StepSpacings> spacingsOf(const ClearanceResult& answer);
/// Broken places by rule, over all steps; empty if no rules were asked for.
[[nodiscard]] std::vector<std::size_t> countsOf(const ClearanceResult& answer);

/// Looks for narrow places of a board and all its steps in the background.
class ClearanceChecker : public QObject {
    Q_OBJECT

public:
    explicit ClearanceChecker(QObject* parent = nullptr);

    /// Cancels a search under way. Layers and nets in the request are the board's own; placed steps are searched only
    /// when neither is named.
    void start(std::shared_ptr<const model::Document> board, ClearanceRequest request);
    [[nodiscard]] Background& background() { return m_search.background(); }

signals:
    void found(const std::shared_ptr<const model::Document>& board, const ClearanceRequest& request,
               const ClearanceResult& answer);
    void failed(const QString& reason);

private:
    void deliver();

    BackgroundResult<ClearanceResult> m_search;
    std::shared_ptr<const model::Document> m_board;
    ClearanceRequest m_request;
};

}  // namespace ui
