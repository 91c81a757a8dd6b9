#include "ui/statistics_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/histogram_view.h"
#include "ui/models/statistics_model.h"
#include "ui/models/statistics_sorter.h"
#include "ui/table_view.h"

namespace ui {

namespace {

/// In the order of model::Measure.
constexpr const char* kMeasures[model::kMeasureCount] = {"Track widths", "Hole diameters",
                                                         "Annular rings (round pads)"};

}  // namespace

StatisticsPanel::StatisticsPanel(models::StatisticsModel& model, QWidget* parent)
    : QWidget(parent), m_table(new TableView), m_plot(new HistogramView), m_measure(new QComboBox) {
    auto* sorter = new models::StatisticsSorter(this);
    sorter->setSourceModel(&model);
    m_table->setModel(sorter);
    m_table->horizontalHeader()->setSortIndicator(
        -1, Qt::AscendingOrder);  // the board's own order until a heading is clicked
    m_table->setSortingEnabled(true);
    connect(sorter, &QAbstractItemModel::modelReset, m_table, &QTableView::resizeColumnsToContents);
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
    halves->addWidget(m_table);
    halves->addWidget(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->addWidget(halves);
}

}  // namespace ui
