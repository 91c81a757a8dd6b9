#include "ui/statistics_panel.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/models/statistics_model.h"
#include "ui/models/statistics_sorter.h"
#include "ui/table_view.h"

namespace ui {

StatisticsPanel::StatisticsPanel(models::StatisticsModel& model, QWidget* parent)
    : QWidget(parent), m_table(new TableView) {
    auto* sorter = new models::StatisticsSorter(this);
    sorter->setSourceModel(&model);
    m_table->setModel(sorter);
    m_table->horizontalHeader()->setSortIndicator(
        -1, Qt::AscendingOrder);  // the board's own order until a heading is clicked
    m_table->setSortingEnabled(true);
    connect(sorter, &QAbstractItemModel::modelReset, m_table, &QTableView::resizeColumnsToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->addWidget(m_table);
}

}  // namespace ui
