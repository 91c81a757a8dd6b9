#pragma once

#include "model/nets/net_check.h"
#include "ui/findings/shown_finding.h"
#include "ui/netlist_check/netlist_check_model.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// Compares the nets of the board with its copper in the background: opens, shorts and floating copper in a panel.
/// While a finding is shown all layers but its own are faint: on the bottom, what lies on top would hide it.
class NetlistCheckFeature : public QObject {
    Q_OBJECT

public:
    explicit NetlistCheckFeature(FeatureContext& context);

private:
    /// A click on a row, Enter, or an arrow key that comes to it, shows its location.
    [[nodiscard]] QWidget* makePanel(const ActionSet& actions);
    void start();
    void deliver();
    /// Until something else is selected.
    void show(const NetlistCheckModel::Finding& finding);

    Workspace& m_workspace;
    ShownFinding m_shown;
    NetlistCheckModel m_findings;
    BackgroundResult<std::vector<model::StepCheck>> m_checks;
    std::shared_ptr<const model::Document> m_board;  ///< that is or was checked
};

}  // namespace ui
