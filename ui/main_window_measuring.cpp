// What the measuring commands of the main window do.
#include <QDockWidget>
#include <QStatusBar>

#include "ui/dialogs.h"
#include "ui/main_window.h"
#include "ui/measurements_panel.h"
#include "ui/message_bar.h"
#include "ui/paths.h"

namespace ui {

void MainWindow::connectMeasuring() {
    const auto use = [this](Measuring::Tool tool) {
        return [this, tool](bool isOn) { m_measuring->setTool(isOn ? tool : Measuring::Tool::None); };
    };
    connect(&m_actions[ActionId::MeasurePoints], &QAction::triggered, this, use(Measuring::Tool::Points));
    connect(&m_actions[ActionId::MeasureObjects], &QAction::triggered, this, use(Measuring::Tool::Objects));
    connect(m_measuring, &Measuring::toolChanged, this, [this] {
        m_actions[ActionId::MeasurePoints].setChecked(m_measuring->tool() == Measuring::Tool::Points);
        m_actions[ActionId::MeasureObjects].setChecked(m_measuring->tool() == Measuring::Tool::Objects);
    });
    connect(&m_actions[ActionId::MeasureGap], &QAction::triggered, m_measuring, &Measuring::measureGapAtCursor);
    connect(&m_actions[ActionId::ExportMeasurements], &QAction::triggered, this, [this] {
        askForTablePath(*this, m_settings.lastFolder(), [this](const QString& path) { exportMeasurements(path); });
    });
    connect(m_measuring, &Measuring::begunAt, m_placeReadout, &PlaceReadout::measureFrom);
    connect(m_measuring, &Measuring::told, this, [this](const QString& what) { statusBar()->showMessage(what); });
    connect(m_measurements, &MeasurementKeeping::notSaved, m_messageBar, &MessageBar::showError);
    connect(m_measurementsPanel, &MeasurementsPanel::chosen, m_measuring, &Measuring::goTo);
    connect(m_measurementsPanel, &MeasurementsPanel::forgotten, m_measurements, &MeasurementKeeping::forget);
}

void MainWindow::exportMeasurements(const QString& path) {
    if (const base::Status written = m_measurements->exportCsv(toPath(path)); !written) {
        m_messageBar->showError(QString::fromStdString(written.error().text));
    } else {
        statusBar()->showMessage(QStringLiteral("Saved %1").arg(path));
    }
}

}  // namespace ui
