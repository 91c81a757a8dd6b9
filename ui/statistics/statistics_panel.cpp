#include "ui/statistics/statistics_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/common/table_view.h"
#include "ui/statistics/drill_model.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_model.h"
#include "ui/statistics/statistics_sorter.h"

namespace ui {

namespace {

/// In the order of model::Measure.
constexpr const char* kMeasures[model::kMeasureCount] = {"Track widths", "Hole diameters",
                                                         "Annular rings (round pads)"};

/// The board's own order until a heading is clicked.
void sortOnClicks(TableView& table, QSortFilterProxyModel& sorter, QAbstractItemModel& model) {
    sorter.setSourceModel(&model);
    table.setModel(&sorter);
    table.horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    table.setSortingEnabled(true);
    QObject::connect(&sorter, &QAbstractItemModel::modelReset, &table, &QTableView::resizeColumnsToContents);
}

}  // namespace

StatisticsPanel::StatisticsPanel(StatisticsModel& model, DrillModel& drills, QWidget* parent)
    : QWidget(parent),
      m_drills(drills),
      m_table(new TableView),
      m_drillTable(new TableView),
      m_tabs(new QTabWidget),
      m_plot(new HistogramView),
      m_measure(new QComboBox) {
    sortOnClicks(*m_table, *new StatisticsSorter(this), model);
    setUpDrills();
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_table, QStringLiteral("Elements"));
    m_tabs->addTab(m_drillTable, QStringLiteral("Drills"));
    for (const char* measure : kMeasures) {
        m_measure->addItem(QString::fromLatin1(measure));
    }
    connect(m_measure, &QComboBox::currentIndexChanged, m_plot,
            [this](int index) { m_plot->setMeasure(static_cast<model::Measure>(index)); });
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_measure);
    column->addWidget(m_plot, 1);
    auto* halves = new QSplitter;
    halves->addWidget(m_tabs);
    halves->addWidget(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->addWidget(halves);
}

void StatisticsPanel::setUpDrills() {
    auto* sorter = new QSortFilterProxyModel(this);
    sorter->setSortRole(Qt::EditRole);
    sortOnClicks(*m_drillTable, *sorter, m_drills);
    m_drillTable->setToolTip(QStringLiteral("Click rows to select their holes"));
    connect(m_drillTable, &QTableView::clicked, this, &StatisticsPanel::chooseHoles);
    connect(m_drillTable, &TableView::enterPressed, this, &StatisticsPanel::chooseHoles);
}

void StatisticsPanel::chooseHoles() {
    const auto* sorter = static_cast<const QSortFilterProxyModel*>(m_drillTable->model());
    std::vector<int> rows;
    for (const QModelIndex& row : m_drillTable->selectionModel()->selectedRows()) {
        rows.push_back(sorter->mapToSource(row).row());
    }
    emit holesChosen(m_drills.holesIn(rows));
}

}  // namespace ui
