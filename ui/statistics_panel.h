#pragma once

#include <QWidget>

namespace ui {

namespace models {
class StatisticsModel;
}
class TableView;

/// Elements by kind per layer and in all; a click on a heading sorts, a second one turns the order.
class StatisticsPanel : public QWidget {
    Q_OBJECT

public:
    explicit StatisticsPanel(models::StatisticsModel& model, QWidget* parent = nullptr);
    [[nodiscard]] TableView& table() { return *m_table; }

private:
    TableView* m_table;
};

}  // namespace ui
