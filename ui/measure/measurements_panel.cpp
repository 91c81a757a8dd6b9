#include "ui/measure/measurements_panel.h"

#include <QHeaderView>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

MeasurementsPanel::MeasurementsPanel(MeasurementModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView(list)) {
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->fitColumns();
    QAction& remove = m_table->addDelete(tr("Delete the selected measurements (Del)"));
    connect(m_table, &TableView::deleteRequested, this, &MeasurementsPanel::forgotten);
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid()) {
            emit chosen(index.row());
        }
    };
    connect(m_table, &QTableView::doubleClicked, this, choose);
    connect(m_table, &TableView::enterPressed, this, choose);
    connect(&list, &QAbstractItemModel::dataChanged, m_table, &QTableView::resizeColumnsToContents);
    QToolBar* tools =
        toolBar({&actions[ActionId::MeasurePoints], &actions[ActionId::MeasureObjects],
                 &actions[ActionId::MeasureAngle], &actions[ActionId::MeasureLines], &actions[ActionId::MeasureRadius],
                 &actions[ActionId::MeasureLength], &actions[ActionId::MeasureSpacing]});
    tools->addSeparator();
    tools->addActions({&remove, &actions[ActionId::ExportMeasurements]});
    auto* column = columnIn(*this);
    column->addWidget(tools);
    column->addWidget(m_table);
}

}  // namespace ui
