#pragma once

#include "ui/measure/measurement_model.h"
#include "ui/workspace/session_part.h"

namespace ui {

/// The measurements of a board: listed, drawn or hidden, renamed and deleted, undone like every other edit, and saved
/// in the session file beside the job.
class SavedMeasurements : public QObject {
    Q_OBJECT

public:
    explicit SavedMeasurements(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] MeasurementModel& list() { return m_list; }
    [[nodiscard]] const MeasurementModel& list() const { return m_list; }
    /// Adds a measurement of the step on the screen under a name of its own, "1", "2" and so on.
    void add(model::Measurement measurement);
    void rename(int row, const QString& name);
    void setShown(int row, bool isShown);
    void remove(const std::vector<int>& rows);

signals:
    void changed();

private:
    using List = MeasurementModel::List;

    void show(const List& measurements);

    Workspace& m_workspace;
    MeasurementModel m_list;
    SessionPart<List> m_part;
};

}  // namespace ui
