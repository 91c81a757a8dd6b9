// What the commands for clearances and rules do.

#include <QStatusBar>

#include "ui/layers/layers_panel.h"
#include "ui/shell/dialogs.h"
#include "ui/shell/main_window.h"
#include "ui/shell/message_bar.h"
#include "ui/shell/status_line.h"

namespace ui {

void MainWindow::connectClearances() {
    Clearances& clearances = *m_clearances;
    const auto on = [this](ActionId id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on(ActionId::SearchClearances, [this, &clearances] {
        m_loader.cancel();
        raise(clearances.panel());
        clearances.measure();
    });
    on(ActionId::NextClearance, [&clearances] { clearances.step(1); });
    on(ActionId::PreviousClearance, [&clearances] { clearances.step(-1); });
    on(ActionId::Lens, [this, &clearances](bool isOn) {
        raise(clearances.panel());
        clearances.lens().setOn(isOn);
    });
    on(ActionId::ClearanceMap, [this, &clearances](bool isOn) {
        raise(clearances.panel());
        clearances.distances().setOn(isOn);
    });
    connect(&m_layerModel, &LayerModel::stylesChanged, &clearances.distances(), &ClearanceMapOverlay::refresh);
    connect(m_layersPanel, &LayersPanel::currentChanged, &clearances.distances(), &ClearanceMapOverlay::refresh);
    m_positionReadout->setNote([&clearances](base::PointD at) { return clearances.distances().textAt(at); });
    clearances.setCurrentLayer([this] { return m_layersPanel->currentLayer(); });
    connect(&clearances, &Clearances::started, this, [this] { onWorking(QStringLiteral("Clearances")); });
    connect(&clearances, &Clearances::progressed, &m_statusLine->loadBar(), &LoadBar::report);
    connect(&clearances, &Clearances::failed, m_messageBar, &MessageBar::showError);
    connect(&clearances, &Clearances::failed, this, &MainWindow::onIdle);
    connect(&clearances, &Clearances::finished, this, [this](const QString& summary) {
        statusBar()->showMessage(QStringLiteral("Clearances: %1").arg(summary));
        onIdle();
    });
    connectRules();
}

void MainWindow::connectRules() {
    Clearances& clearances = *m_clearances;
    const auto tell = [this](const base::Status& done, const QString& path) {
        if (!done) {
            m_messageBar->showError(QString::fromStdString(done.error().text));
        } else {
            statusBar()->showMessage(path);
        }
    };
    connect(&m_actions[ActionId::EditRules], &QAction::triggered, this, [this, &clearances] {
        raise(clearances.panel());
        clearances.editRules(*this);
    });
    connect(&m_actions[ActionId::ExportClearances], &QAction::triggered, this, [this, &clearances, tell] {
        requestReportPath(*this, m_settings.lastFolder(), [&clearances, tell](const QString& path) {
            tell(clearances.exportReport(path), QStringLiteral("Saved %1").arg(path));
        });
    });
    connect(&clearances.panel(), &ClearancePanel::rulesAsked, this, [this, &clearances, tell] {
        requestRulesToOpen(*this, m_settings.lastFolder(), [&clearances, tell](const QString& path) {
            tell(clearances.openRules(path), QStringLiteral("Rules of %1").arg(path));
        });
    });
    connect(&clearances.panel(), &ClearancePanel::rulesSaved, this, [this, &clearances, tell] {
        requestRulesPath(*this, m_settings.lastFolder(), [&clearances, tell](const QString& path) {
            tell(clearances.saveRules(path), QStringLiteral("Saved %1").arg(path));
        });
    });
}

}  // namespace ui
