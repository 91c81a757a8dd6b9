#include "ui/measurements_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QToolBar>

#include "ui/actions.h"
#include "ui/table_view.h"

namespace ui {

MeasurementsPanel::MeasurementsPanel(models::MeasurementModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView), m_forget(new QAction(QStringLiteral("Forget"), this)) {
    m_table->setModel(&list);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_forget->setShortcut(QKeySequence::Delete);
    m_forget->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_forget->setToolTip(QStringLiteral("Forget the chosen measurements (Del)"));
    addAction(m_forget);
    connect(m_forget, &QAction::triggered, this, &MeasurementsPanel::forgetSelected);
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
          ActionId::MeasureRadius, ActionId::MeasureLength, ActionId::MeasureGap}) {
        tools->addAction(&actions[id]);
    }
    tools->addSeparator();
    tools->addAction(m_forget);
    tools->addAction(&actions[ActionId::ExportMeasurements]);
    auto* row = new QHBoxLayout;
    row->addWidget(tools, 1);
    layOut(*this, row, m_table);
}

void MeasurementsPanel::forgetSelected() {
    std::vector<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    if (!rows.empty()) {
        emit forgotten(rows);
    }
}

}  // namespace ui
