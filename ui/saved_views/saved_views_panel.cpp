#include "ui/saved_views/saved_views_panel.h"

#include <QHeaderView>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

SavedViewsPanel::SavedViewsPanel(ViewListModel& list, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView(list)) {
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    QAction& remove = m_table->addDelete(tr("Delete the selected view or selection (Del)"));
    connect(m_table, &TableView::deleteRequested, this, [this](const auto& rows) { emit forgotten(rows.front()); });
    connect(m_table, &TableView::rowChosen, this, &SavedViewsPanel::chosen);
    auto* column = columnIn(*this);
    column->addLayout(buttonRow({&actions[ActionId::SaveView], &actions[ActionId::SaveSelection], &remove}));
    column->addWidget(m_table);
}

}  // namespace ui
