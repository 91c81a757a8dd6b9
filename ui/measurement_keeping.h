#pragma once

#include <QObject>
#include <QUndoStack>

#include "ui/models/measurement_model.h"
#include "ui/session_part.h"

namespace ui {

/// The measurements of a board: listed, drawn or hidden, renamed and forgotten, undone like every other edit, and kept
/// in the session file beside the job.
class MeasurementKeeping : public QObject {
    Q_OBJECT

public:
    explicit MeasurementKeeping(QUndoStack& history, QObject* parent = nullptr);

    [[nodiscard]] models::MeasurementModel& list() { return m_list; }
    [[nodiscard]] const models::MeasurementModel& list() const { return m_list; }
    void setBoard(const LoadedBoard& board);
    /// Keeps a measurement of the step on the screen under a name of its own, "1", "2" and so on.
    void keep(model::session::Measurement measurement);
    void rename(int row, const QString& name);
    void setShown(int row, bool isShown);
    void forget(const std::vector<int>& rows);
    /// Errors: OutputFailed.
    [[nodiscard]] base::Status exportCsv(const std::filesystem::path& path) const;
    /// Is it of the step on the screen?
    [[nodiscard]] bool isHere(const model::session::Measurement& measurement) const;

signals:
    void changed();
    void notSaved(const QString& reason);

private:
    using List = models::MeasurementModel::List;

    void change(const QString& what, List after);
    void apply(const List& measurements);

    QUndoStack& m_history;
    models::MeasurementModel m_list;
    SessionPart m_session;
};

}  // namespace ui
