#pragma once

#include <QWidget>
#include <vector>

#include "ui/measure/measurement_model.h"

namespace ui {

class ActionSet;
class TableView;

/// The list of measurements with its commands above it. The box before a name draws or hides a measurement, F2 renames
/// it, a double click or Enter shows it, Del deletes all that are selected.
class MeasurementPanel : public QWidget {
    Q_OBJECT

public:
    MeasurementPanel(MeasurementModel& list, const ActionSet& actions, QWidget* parent = nullptr);

    void scrollToLast();

signals:
    /// Rows of the list.
    void chosen(int row);
    void deleteRequested(const std::vector<int>& rows);

private:
    void addCommands(const ActionSet& actions);
    [[nodiscard]] QWidget* tools(const ActionSet& actions, QAction& remove);

    TableView* m_table;
};

}  // namespace ui
