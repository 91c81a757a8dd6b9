#include "ui/statistics/statistics_panel.h"

#include <QComboBox>
#include <QSplitter>
#include <QTabWidget>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/statistics/drill_model.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_model.h"

namespace ui {

StatisticsPanel::StatisticsPanel(StatisticsModel& model, DrillModel& drills, QWidget* parent)
    : QWidget(parent),
      m_table(new TableView(model)),
      m_drillTable(new TableView(drills)),
      m_tabs(new QTabWidget),
      m_plot(new HistogramView) {
    for (TableView* table : {m_table, m_drillTable}) {
        table->makeSortable();
        table->fitColumns();
    }
    m_drillTable->setToolTip(tr("Click rows to select their holes"));
    connect(m_drillTable, &TableView::rowChosen, this,
            [this, &drills] { emit holesChosen(drills.holesIn(m_drillTable->selectedRows())); });
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_table, tr("Elements"));
    m_tabs->addTab(m_drillTable, tr("Drills"));
    // In the order of model::Measure.
    auto* measure = new QComboBox;
    measure->addItems({tr("Track widths"), tr("Hole diameters"), tr("Annular rings (round pads)")});
    connect(measure, &QComboBox::currentIndexChanged, m_plot,
            [this](int index) { m_plot->setMeasure(static_cast<model::Measure>(index)); });
    auto* right = new QWidget;
    auto* column = columnIn(*right, 0);
    column->addWidget(measure);
    column->addWidget(m_plot, 1);
    auto* halves = new QSplitter;
    halves->addWidget(m_tabs);
    halves->addWidget(right);
    columnIn(*this)->addWidget(halves);
}

}  // namespace ui
