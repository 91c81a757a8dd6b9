#include "ui/measure/saved_measurements.h"

#include <algorithm>

namespace ui {

SavedMeasurements::SavedMeasurements(Workspace& workspace, QObject* parent)
    : QObject(parent),
      m_workspace(workspace),
      m_list(this),
      m_part(
          workspace, tr("The measurements"), [this](const List& measurements) { show(measurements); },
          model::session::saveMeasurements) {
    connect(&m_list, &MeasurementModel::renamed, this, &SavedMeasurements::rename);
    connect(&m_list, &MeasurementModel::shownChanged, this, &SavedMeasurements::setShown);
    connect(&workspace, &Workspace::unitChanged, &m_list, &MeasurementModel::setUnit);
    connect(&workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        if (m_part.open()) {
            show(board.session.measurements);
        }
    });
}

void SavedMeasurements::show(const List& measurements) {
    m_list.setMeasurements(measurements);
    emit changed();
}

void SavedMeasurements::add(model::Measurement measurement) {
    List after = m_list.measurements();
    measurement.name = freeName(after, "");
    measurement.step = m_workspace.board()->document->job.step;
    after.push_back(std::move(measurement));
    m_part.edit(tr("a measurement"), m_list.measurements(), std::move(after));
}

void SavedMeasurements::rename(int row, const QString& name) {
    List after = m_list.measurements();
    after[static_cast<std::size_t>(row)].name = name.toStdString();
    m_part.edit(tr("the name of a measurement"), m_list.measurements(), std::move(after));
}

void SavedMeasurements::setShown(int row, bool isShown) {
    List after = m_list.measurements();
    after[static_cast<std::size_t>(row)].isShown = isShown;
    m_part.edit(isShown ? tr("showing a measurement") : tr("hiding a measurement"), m_list.measurements(),
                std::move(after));
}

void SavedMeasurements::remove(const std::vector<int>& rows) {
    List after;
    for (int row = 0; row < m_list.rowCount(); ++row) {
        if (std::ranges::find(rows, row) == rows.end()) {
            after.push_back(m_list.measurements()[static_cast<std::size_t>(row)]);
        }
    }
    if (after.size() < m_list.measurements().size()) {
        m_part.edit(tr("deleting measurements"), m_list.measurements(), std::move(after));
    }
}

}  // namespace ui
