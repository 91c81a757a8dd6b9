#include "ui/measure/saved_measurements.h"

#include <algorithm>
#include <fstream>

#include "ui/workspace/state_edit.h"

namespace ui {

namespace session = model::session;

SavedMeasurements::SavedMeasurements(QUndoStack& history, QObject* parent) : QObject(parent), m_history(history) {
    connect(&m_list, &MeasurementModel::renamed, this, &SavedMeasurements::rename);
    connect(&m_list, &MeasurementModel::shownChanged, this, &SavedMeasurements::setShown);
}

void SavedMeasurements::setBoard(const LoadedBoard& board) {
    if (m_session.open(board)) {
        m_list.setMeasurements(board.measurements);
    }
    emit changed();
}

bool SavedMeasurements::isHere(const model::Measurement& measurement) const {
    return m_session.document() != nullptr && measurement.step == m_session.document()->job.step;
}

void SavedMeasurements::keep(model::Measurement measurement) {
    if (m_session.document() == nullptr) {
        return;
    }
    List after = m_list.measurements();
    std::size_t number = after.size() + 1;
    while (std::ranges::find(after, std::to_string(number), &model::Measurement::name) != after.end()) {
        ++number;
    }
    measurement.name = std::to_string(number);
    measurement.step = m_session.document()->job.step;
    after.push_back(std::move(measurement));
    change(QStringLiteral("a measurement"), std::move(after));
}

void SavedMeasurements::rename(int row, const QString& name) {
    List after = m_list.measurements();
    after[static_cast<std::size_t>(row)].name = name.toStdString();
    change(QStringLiteral("the name of a measurement"), std::move(after));
}

void SavedMeasurements::setShown(int row, bool isShown) {
    List after = m_list.measurements();
    after[static_cast<std::size_t>(row)].isShown = isShown;
    change(isShown ? QStringLiteral("showing a measurement") : QStringLiteral("hiding a measurement"),
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
        change(QStringLiteral("forgetting measurements"), std::move(after));
    }
}

base::Status SavedMeasurements::exportCsv(const std::filesystem::path& path) const {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << model::measurementsCsv(m_list.measurements());
    file.close();
    return file ? base::Status(base::Done{})
                : base::Status(base::Error{base::ErrorCode::OutputFailed, path.string() + " cannot be written"});
}

void SavedMeasurements::change(const QString& what, List after) {
    m_history.push(new StateEdit<List>(what, m_list.measurements(), std::move(after),
                                       [this](const List& measurements) { apply(measurements); }));
}

void SavedMeasurements::apply(const List& measurements) {
    m_list.setMeasurements(measurements);
    emit changed();
    const QString trouble =
        m_session.save(QStringLiteral("The measurements"), [&](const auto& path, const auto& document) {
            return session::saveMeasurements(path, document, measurements);
        });
    if (!trouble.isEmpty()) {
        emit notSaved(trouble);
    }
}

}  // namespace ui
