#include "ui/nets/net_check_panel.h"

#include <QLabel>

#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/workspace/actions.h"

namespace ui {

NetCheckPanel::NetCheckPanel(NetCheckModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_table(new TableView(model)), m_summary(new QLabel(model.summary())) {
    m_filterEdit = ui::filterEdit(m_table->makeSortable(), tr("Filter by net, layer or kind"));
    m_table->fitColumns(NetCheckModel::What);
    connect(m_table, &TableView::rowChosen, this, [this, &model](int row) { emit chosen(model.finding(row)); });
    connect(&model, &QAbstractItemModel::modelReset, this, [this, &model] { m_summary->setText(model.summary()); });
    auto* controls = buttonRow({&actions[ActionId::CheckNets], &actions[ActionId::InferNets]});
    controls->addWidget(m_filterEdit, 1);
    controls->addWidget(m_summary);
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addWidget(m_table);
}

QString NetCheckPanel::summary() const {
    return m_summary->text();
}

}  // namespace ui
