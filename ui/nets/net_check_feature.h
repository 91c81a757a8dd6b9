#pragma once

#include "model/nets/net_check.h"
#include "ui/nets/net_check_model.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// Compares the nets of the board with its copper in the background: opens, shorts and floating copper in a panel.
class NetCheck : public QObject {
    Q_OBJECT

public:
    explicit NetCheck(FeatureContext& context);

private:
    /// A click on a row, or Enter, shows its location.
    [[nodiscard]] QWidget* makePanel(const ActionSet& actions);
    void start();
    void deliver();
    void show(const NetCheckModel::Finding& finding);

    Workspace& m_workspace;
    NetCheckModel m_findings;
    BackgroundResult<std::vector<model::StepCheck>> m_checks;
    std::shared_ptr<const model::Document> m_board;  ///< that is or was checked
};

}  // namespace ui
