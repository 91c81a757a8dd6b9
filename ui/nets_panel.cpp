#include "ui/nets_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>

#include "ui/table_view.h"

namespace ui {

namespace {

using models::NetModel;

constexpr const char* kKinds[] = {"Text", "Wildcard", "Regex"};

}  // namespace

NetsPanel::NetsPanel(NetModel& model, models::SelectionModel& selection, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_selection(selection),
      m_filter(new QLineEdit),
      m_kind(new QComboBox),
      m_summary(new QLabel),
      m_table(new TableView) {
    m_filter->setPlaceholderText(QStringLiteral("Filter nets by name"));
    m_filter->setClearButtonEnabled(true);
    for (const char* kind : kKinds) {
        m_kind->addItem(QString::fromLatin1(kind));
    }
    m_table->setModel(&model);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(NetModel::Name, Qt::AscendingOrder);
    const int letter = fontMetrics().horizontalAdvance('0');
    m_table->setColumnWidth(NetModel::Name, letter * 15);
    for (int column = NetModel::Pins; column < NetModel::ColumnCount; ++column) {
        m_table->setColumnWidth(column, letter * (column < NetModel::Length ? 7 : 12));
    }
    m_table->horizontalHeader()->setStretchLastSection(true);
    connect(m_filter, &QLineEdit::textChanged, this, &NetsPanel::applyFilter);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &NetsPanel::applyFilter);
    connect(&model, &NetModel::arranged, this, &NetsPanel::onArranged);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &NetsPanel::takeFromTable);
    connect(m_table, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit showRequested(m_model.netAt(index.row())); });
    connect(&selection, &models::SelectionModel::netsChanged, this, &NetsPanel::showInTable);
    connect(&selection, &models::SelectionModel::selectionChanged, this, &NetsPanel::scrollToSelected);
    auto* row = new QHBoxLayout;
    row->addWidget(m_filter, 1);
    row->addWidget(m_kind);
    row->addWidget(m_summary);
    layOut(*this, row, m_table);
}

void NetsPanel::applyFilter() {
    const bool isValid = m_model.setFilter(m_filter->text(), static_cast<NetModel::FilterKind>(m_kind->currentIndex()));
    m_filter->setToolTip(isValid ? QString() : QStringLiteral("This is not a regular expression; all nets are shown"));
    QPalette colours = palette();
    if (!isValid) {
        colours.setColor(QPalette::Text, Qt::red);
    }
    m_filter->setPalette(colours);
}

void NetsPanel::onArranged() {
    m_summary->setText(QStringLiteral("%L1 of %L2").arg(m_model.rowCount()).arg(m_model.total()));
    showInTable();
}

void NetsPanel::takeFromTable() {
    if (m_isSyncing) {
        return;
    }
    const QScopedValueRollback guard(m_isSyncing, true);
    std::vector<model::NetId> nets;
    for (const QItemSelectionRange& range : m_table->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            nets.push_back(m_model.netAt(row));
        }
    }
    const bool isOne = nets.size() == 1;
    m_selection.setNets(std::move(nets));
    if (m_showsChosen && isOne) {
        emit showRequested(m_selection.nets().front());
    }
}

void NetsPanel::showInTable() {
    if (m_isSyncing) {
        return;
    }
    const QScopedValueRollback guard(m_isSyncing, true);
    QItemSelection rows;
    for (const model::NetId net : m_selection.nets()) {
        if (const std::optional<int> row = m_model.rowOf(net)) {
            rows.select(m_model.index(*row, 0), m_model.index(*row, NetModel::ColumnCount - 1));
        }
    }
    m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

void NetsPanel::scrollToSelected() {
    const auto current = m_selection.current();
    if (!m_follows || !current || current->copy != 0) {
        return;
    }
    const model::NetId net = m_selection.stepOf(*current).elements.net[current->element.row()];
    const std::optional<int> row = net.isValid() ? m_model.rowOf(net) : std::nullopt;
    if (row) {
        m_table->selectionModel()->setCurrentIndex(m_model.index(*row, NetModel::Name), QItemSelectionModel::NoUpdate);
        m_table->scrollTo(m_model.index(*row, NetModel::Name));
    }
}

QString NetsPanel::summary() const {
    return m_summary->text();
}

}  // namespace ui
