// What the measuring commands of the main window do.
#include <QDockWidget>
#include <QStatusBar>

#include "ui/common/paths.h"
#include "ui/measure/measurements_panel.h"
#include "ui/shell/dialogs.h"
#include "ui/shell/main_window.h"
#include "ui/shell/message_bar.h"

namespace ui {

namespace {

constexpr std::pair<ActionId, Measuring::Tool> kTools[] = {
    {ActionId::MeasurePoints, Measuring::Tool::Points}, {ActionId::MeasureObjects, Measuring::Tool::Objects},
    {ActionId::MeasureAngle, Measuring::Tool::Angle},   {ActionId::MeasureLines, Measuring::Tool::Lines},
    {ActionId::MeasureRadius, Measuring::Tool::Radius}, {ActionId::MeasureLength, Measuring::Tool::Length}};

}  // namespace

void MainWindow::connectMeasuring() {
    for (const auto& [id, tool] : kTools) {
        connect(&m_actions[id], &QAction::triggered, this,
                [this, use = tool](bool isOn) { m_measuring->setTool(isOn ? use : Measuring::Tool::None); });
    }
    connect(m_measuring, &Measuring::toolChanged, this, [this] {
        for (const auto& [id, tool] : kTools) {
            m_actions[id].setChecked(m_measuring->tool() == tool);
        }
    });
    connect(&m_actions[ActionId::MeasureSpacing], &QAction::triggered, m_measuring, &Measuring::measureSpacingAtCursor);
    connect(&m_actions[ActionId::ExportMeasurements], &QAction::triggered, this, [this] {
        requestTablePath(*this, m_settings.lastFolder(), [this](const QString& path) { exportMeasurements(path); });
    });
    connect(m_measuring, &Measuring::begunAt, m_positionReadout, &PositionReadout::measureFrom);
    connect(m_measuring, &Measuring::reported, this, [this](const QString& what) { statusBar()->showMessage(what); });
    connect(m_measuring, &Measuring::followingBegan, this, [this] { onWorking(QStringLiteral("Length")); });
    connect(m_measuring, &Measuring::progressed, &m_statusLine->loadBar(), &LoadBar::report);
    connect(m_measuring, &Measuring::followingEnded, this, &MainWindow::onIdle);
    connect(m_clearances, &Clearances::spacingShown, m_measuring, &Measuring::showSpacing);
    connect(m_measurements, &SavedMeasurements::notSaved, m_messageBar, &MessageBar::showError);
    connect(m_measurementsPanel, &MeasurementsPanel::chosen, m_measuring, &Measuring::goTo);
    connect(m_measurementsPanel, &MeasurementsPanel::forgotten, m_measurements, &SavedMeasurements::remove);
}

void MainWindow::exportMeasurements(const QString& path) {
    if (const base::Status written = m_measurements->exportCsv(toPath(path)); !written) {
        m_messageBar->showError(QString::fromStdString(written.error().text));
    } else {
        statusBar()->showMessage(QStringLiteral("Saved %1").arg(path));
    }
}

}  // namespace ui
