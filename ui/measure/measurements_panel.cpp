#include "ui/measure/measurements_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QToolBar>

#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

MeasurementsPanel::MeasurementsPanel(MeasurementModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView), m_delete(new QAction(QStringLiteral("Forget"), this)) {
    m_table->setModel(&list);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_delete->setShortcut(QKeySequence::Delete);
    m_delete->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_delete->setToolTip(QStringLiteral("Forget the chosen measurements (Del)"));
    addAction(m_delete);
    connect(m_delete, &QAction::triggered, this, &MeasurementsPanel::deleteSelected);
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid()) {
            emit chosen(index.row());
        }
    };
    connect(m_table, &QTableView::doubleClicked, this, choose);
    connect(m_table, &TableView::enterPressed, this, choose);
    const auto fitColumns = [this] { m_table->resizeColumnsToContents(); };
    connect(&list, &QAbstractItemModel::modelReset, this, fitColumns);
    connect(&list, &QAbstractItemModel::dataChanged, this, fitColumns);

    // A tool bar folds what has no room into a menu: the buttons do not widen the window.
    auto* tools = new QToolBar;
    for (const ActionId id :
         {ActionId::MeasurePoints, ActionId::MeasureObjects, ActionId::MeasureAngle, ActionId::MeasureLines,
          ActionId::MeasureRadius, ActionId::MeasureLength, ActionId::MeasureSpacing}) {
        tools->addAction(&actions[id]);
    }
    tools->addSeparator();
    tools->addAction(m_delete);
    tools->addAction(&actions[ActionId::ExportMeasurements]);
    auto* row = new QHBoxLayout;
    row->addWidget(tools, 1);
    layOut(*this, row, m_table);
}

void MeasurementsPanel::deleteSelected() {
    std::vector<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    if (!rows.empty()) {
        emit forgotten(rows);
    }
}

}  // namespace ui
