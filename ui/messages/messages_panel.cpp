#include "ui/messages/messages_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>

#include "ui/common/table_view.h"
#include "ui/messages/message_model.h"

namespace ui {

namespace {

using model::Severity;

constexpr std::pair<Severity, const char*> kChoices[] = {
    {Severity::Info, "Everything"},
    {Severity::Warning, "Warnings and errors"},
    {Severity::Error, "Errors only"},
};

}  // namespace

MessagesPanel::MessagesPanel(MessageModel& model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_filter(new MessageFilter(this)),
      m_table(new TableView),
      m_words(new QLineEdit),
      m_severity(new QComboBox),
      m_summary(new QLabel) {
    m_filter->setSourceModel(&model);
    m_table->setModel(m_filter);
    m_table->horizontalHeader()->setSortIndicator(MessageModel::Severity, Qt::DescendingOrder);
    m_table->setSortingEnabled(true);
    m_words->setPlaceholderText(QStringLiteral("Filter by words of the message or the file"));
    m_words->setClearButtonEnabled(true);
    for (const auto& [severity, text] : kChoices) {
        m_severity->addItem(QString::fromUtf8(text), static_cast<int>(severity));
    }
    connect(m_words, &QLineEdit::textChanged, m_filter, &MessageFilter::setWords);
    connect(m_severity, &QComboBox::currentIndexChanged, this,
            [this] { m_filter->setLeastSeverity(static_cast<Severity>(m_severity->currentData().toInt())); });
    connect(m_filter, &QAbstractItemModel::modelReset, this, &MessagesPanel::fitColumns);
    connect(m_table, &QTableView::clicked, this, &MessagesPanel::choose);
    connect(m_table, &TableView::enterPressed, this, &MessagesPanel::choose);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        connect(m_filter, signal, this, &MessagesPanel::updateSummary);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(m_words, 1);
    row->addWidget(m_severity);
    row->addWidget(m_summary);
    layOut(*this, row, m_table);
    fitColumns();
}

void MessagesPanel::choose(const QModelIndex& index) {
    if (index.isValid()) {
        emit chosen(m_model.message(m_filter->mapToSource(index).row()));
    }
}

void MessagesPanel::updateSummary() {
    m_summary->setText(QStringLiteral("%1 of %2").arg(m_filter->rowCount()).arg(m_model.rowCount()));
}

void MessagesPanel::fitColumns() {
    updateSummary();
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSectionResizeMode(MessageModel::Text, QHeaderView::Stretch);
}

}  // namespace ui
