#pragma once

#include <QWidget>
#include <vector>

#include "model/base/ids.h"

class QTabWidget;

namespace ui {

class DrillModel;
class StatisticsModel;
class HistogramView;
class TableView;

/// Elements by kind per layer and in all, and behind a second tab the drill table; a click on a heading sorts. Beside
/// them how track widths, holes or annular rings are spread.
class StatisticsPanel : public QWidget {
    Q_OBJECT

public:
    StatisticsPanel(StatisticsModel& model, DrillModel& drills, QWidget* parent = nullptr);
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] TableView& drillTable() { return *m_drillTable; }
    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] HistogramView& plot() { return *m_plot; }

signals:
    /// The holes of the rows selected in the drill table: after a click into it, or Enter.
    void holesChosen(const std::vector<model::ElementId>& holes);

private:
    TableView* m_table;
    TableView* m_drillTable;
    QTabWidget* m_tabs;
    HistogramView* m_plot;
};

}  // namespace ui
