#include "ui/messages/messages_panel.h"

#include <QComboBox>
#include <QLabel>

#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_view.h"
#include "ui/messages/message_model.h"

namespace ui {

MessagesPanel::MessagesPanel(MessageModel& model, QWidget* parent) : QWidget(parent), m_table(new TableView(model)) {
    SortedRows& rows = m_table->makeSortable();
    m_table->sortByColumn(MessageModel::Severity, Qt::DescendingOrder);
    m_table->fitColumns(MessageModel::Text);
    QLineEdit* words = filterEdit(rows, tr("Filter by words of the message or the file"));
    auto* severity = new QComboBox;
    severity->addItems({tr("Everything"), tr("Warnings and errors"), tr("Errors only")});  // by least severity
    connect(severity, &QComboBox::currentIndexChanged, &rows, &SortedRows::setLeastRank);
    connect(m_table, &TableView::rowChosen, this, [this, &model](int row) { emit chosen(model.message(row)); });
    auto* summary = new QLabel;
    const auto updateSummary = [&rows, &model, summary] {
        summary->setText(tr("%1 of %2").arg(rows.rowCount()).arg(model.rowCount()));
    };
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        connect(&rows, signal, this, updateSummary);
    }
    connect(&rows, &QAbstractItemModel::modelReset, this, updateSummary);
    updateSummary();
    auto* controls = new QHBoxLayout;
    controls->addWidget(words, 1);
    controls->addWidget(severity);
    controls->addWidget(summary);
    auto* column = columnIn(*this);
    column->addLayout(controls);
    column->addWidget(m_table);
}

}  // namespace ui
