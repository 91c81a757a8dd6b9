#include "ui/nets/net_check_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>

#include "ui/common/table_view.h"
#include "ui/common/tool_button.h"
#include "ui/workspace/actions.h"

namespace ui {

NetCheckPanel::NetCheckPanel(NetCheckModel& model, const ActionSet& actions, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_filter(new QSortFilterProxyModel(this)),
      m_filterEdit(new QLineEdit),
      m_summary(new QLabel),
      m_table(new TableView) {
    m_filter->setSourceModel(&model);
    m_filter->setSortRole(Qt::EditRole);
    m_filter->setFilterKeyColumn(-1);
    m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_table->setModel(m_filter);
    m_table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);  // the weighty ones first
    m_table->setSortingEnabled(true);
    m_filterEdit->setPlaceholderText(QStringLiteral("Filter by net, layer or kind"));
    m_filterEdit->setClearButtonEnabled(true);
    connect(m_filterEdit, &QLineEdit::textChanged, m_filter, &QSortFilterProxyModel::setFilterFixedString);
    connect(m_table, &QTableView::clicked, this, &NetCheckPanel::choose);
    connect(m_table, &TableView::enterPressed, this, &NetCheckPanel::choose);
    connect(&model, &QAbstractItemModel::modelReset, this, &NetCheckPanel::onReset);

    auto* row = new QHBoxLayout;
    for (const ActionId id : {ActionId::CheckNets, ActionId::InferNets}) {
        row->addWidget(toolButton(actions[id]));
    }
    row->addWidget(m_filterEdit, 1);
    row->addWidget(m_summary);
    layOut(*this, row, m_table);
    onReset();
}

void NetCheckPanel::choose(const QModelIndex& index) {
    if (index.isValid()) {
        emit chosen(m_model.finding(m_filter->mapToSource(index).row()));
    }
}

void NetCheckPanel::onReset() {
    m_summary->setText(m_model.summary());
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSectionResizeMode(NetCheckModel::What, QHeaderView::Stretch);
}

QString NetCheckPanel::summary() const {
    return m_summary->text();
}

}  // namespace ui
