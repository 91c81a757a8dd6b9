#include "ui/saved_views/saved_views_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>

#include "ui/common/table_view.h"
#include "ui/common/tool_button.h"
#include "ui/workspace/actions.h"

namespace ui {

SavedViewsPanel::SavedViewsPanel(ViewListModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView), m_delete(new QAction(QStringLiteral("Forget"), this)) {
    m_table->setModel(&list);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_delete->setShortcut(QKeySequence::Delete);
    m_delete->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_delete->setToolTip(QStringLiteral("Forget the chosen view or selection (Del)"));
    addAction(m_delete);
    connect(m_delete, &QAction::triggered, this, [this] {
        if (m_table->currentIndex().isValid()) {
            emit forgotten(m_table->currentIndex().row());
        }
    });
    const auto choose = [this](const QModelIndex& index) {
        if (index.isValid()) {
            emit chosen(index.row());
        }
    };
    connect(m_table, &QTableView::clicked, this, choose);
    connect(m_table, &TableView::enterPressed, this, choose);

    auto* row = new QHBoxLayout;
    row->addWidget(toolButton(actions[ActionId::SaveView]));
    row->addWidget(toolButton(actions[ActionId::SaveSelection]));
    row->addWidget(toolButton(*m_delete));
    row->addStretch(1);
    layOut(*this, row, m_table);
}

}  // namespace ui
