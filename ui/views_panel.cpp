#include "ui/views_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>

#include "ui/actions.h"
#include "ui/table_view.h"
#include "ui/tool_button.h"

namespace ui {

ViewsPanel::ViewsPanel(models::ViewListModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView), m_forget(new QAction(QStringLiteral("Forget"), this)) {
    m_table->setModel(&list);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_forget->setShortcut(QKeySequence::Delete);
    m_forget->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_forget->setToolTip(QStringLiteral("Forget the chosen view or selection (Del)"));
    addAction(m_forget);
    connect(m_forget, &QAction::triggered, this, [this] {
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
    row->addWidget(toolButton(actions[ActionId::KeepView]));
    row->addWidget(toolButton(actions[ActionId::KeepSelection]));
    row->addWidget(toolButton(*m_forget));
    row->addStretch(1);
    layOut(*this, row, m_table);
}

}  // namespace ui
