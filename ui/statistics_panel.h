#pragma once

#include <QWidget>

class QComboBox;

namespace ui {

namespace models {
class StatisticsModel;
}
class HistogramView;
class TableView;

/// Elements by kind per layer and in all; a click on a heading sorts, a second one turns the order. Beside them how
/// track widths, holes or annular rings are spread.
class StatisticsPanel : public QWidget {
    Q_OBJECT

public:
    explicit StatisticsPanel(models::StatisticsModel& model, QWidget* parent = nullptr);
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] HistogramView& plot() { return *m_plot; }
    [[nodiscard]] QComboBox& measureBox() { return *m_measure; }

private:
    TableView* m_table;
    HistogramView* m_plot;
    QComboBox* m_measure;
};

}  // namespace ui
