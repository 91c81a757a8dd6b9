#include "ui/measure/measurement_panel.h"

#include <QHeaderView>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

MeasurementPanel::MeasurementPanel(MeasurementModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView(list)) {
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->fitColumns();
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid()) {
            emit chosen(index.row());
        }
    };
    connect(m_table, &QTableView::doubleClicked, this, choose);
    connect(m_table, &TableView::enterPressed, this, choose);
    connect(m_table, &TableView::deleteRequested, this, &MeasurementPanel::deleteRequested);
    connect(&list, &QAbstractItemModel::dataChanged, m_table, &QTableView::resizeColumnsToContents);
    addCommands(actions);
}

void MeasurementPanel::addCommands(const ActionSet& actions) {
    QAction* show =
        m_table->addAction(tr("Show"), m_table, [this] { emit m_table->enterPressed(m_table->currentIndex()); });
    show->setToolTip(tr("Bring the measurement to the middle of both views (Enter)"));
    m_table->addAction(tr("Rename"), m_table,
                       [this] { m_table->edit(m_table->currentIndex().siblingAtColumn(MeasurementModel::Name)); });
    QAction& remove = m_table->addDelete(tr("Delete the selected measurements (Del)"));
    m_table->addAction(&actions[ActionId::Undo]);
    auto* column = columnIn(*this);
    column->addWidget(tools(actions, remove));
    column->addWidget(m_table);
}

QWidget* MeasurementPanel::tools(const ActionSet& actions, QAction& remove) {
    QToolBar* tools =
        toolBar({&actions[ActionId::MeasurePoints], &actions[ActionId::MeasureObjects],
                 &actions[ActionId::MeasureAngle], &actions[ActionId::MeasureLines], &actions[ActionId::MeasureRadius],
                 &actions[ActionId::MeasureLength], &actions[ActionId::MeasureSpacing]});
    tools->addSeparator();
    tools->addActions({&remove, &actions[ActionId::ExportMeasurements]});
    return tools;
}

void MeasurementPanel::scrollToLast() {
    m_table->scrollToBottom();
}

}  // namespace ui
