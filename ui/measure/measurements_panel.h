#pragma once

#include <QWidget>

#include "ui/measure/measurement_model.h"

namespace ui {

class ActionSet;
class TableView;

/// The measurements. The box draws or hides one, F2 renames it, a double click or Enter brings it to the middle, Del
/// deletes all selected ones, Ctrl+C copies them as text.
class MeasurementsPanel : public QWidget {
    Q_OBJECT

public:
    MeasurementsPanel(MeasurementModel& list, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }

signals:
    void chosen(int row);
    void forgotten(const std::vector<int>& rows);

private:
    TableView* m_table;
};

}  // namespace ui
