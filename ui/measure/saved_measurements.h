#pragma once

#include <QObject>
#include <QUndoStack>

#include "ui/measure/measurement_model.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// The measurements of a board: listed, drawn or hidden, renamed and forgotten, undone like every other edit, and kept
/// in the session file beside the job.
class SavedMeasurements : public QObject {
    Q_OBJECT

public:
    explicit SavedMeasurements(QUndoStack& history, QObject* parent = nullptr);

    [[nodiscard]] MeasurementModel& list() { return m_list; }
    [[nodiscard]] const MeasurementModel& list() const { return m_list; }
    void setBoard(const LoadedBoard& board);
    /// Keeps a measurement of the step on the screen under a name of its own, "1", "2" and so on.
    void keep(model::Measurement measurement);
    void rename(int row, const QString& name);
    void setShown(int row, bool isShown);
    void remove(const std::vector<int>& rows);
    /// Errors: OutputFailed.
    [[nodiscard]] base::Status exportCsv(const std::filesystem::path& path) const;
    /// Is it of the step on the screen?
    [[nodiscard]] bool isHere(const model::Measurement& measurement) const;

signals:
    void changed();
    void notSaved(const QString& reason);

private:
    using List = MeasurementModel::List;

    void change(const QString& what, List after);
    void apply(const List& measurements);

    QUndoStack& m_history;
    MeasurementModel m_list;
    SessionPart m_session;
};

}  // namespace ui
