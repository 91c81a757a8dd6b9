#include "ui/parts/linked_table.h"

#include <QLineEdit>
#include <QScopedValueRollback>
#include <algorithm>

#include "ui/common/panel_parts.h"
#include "ui/common/sorted_rows.h"

namespace ui {

LinkedTable::LinkedTable(TableModel& model, QWidget* parent) : TableView(model, parent), m_sorted(makeSortable()) {
    setTextElideMode(Qt::ElideMiddle);  // long names differ at their ends
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &LinkedTable::takeSelected);
}

QLineEdit* LinkedTable::makeFilter(const QString& hint) {
    QLineEdit* line = filterEdit(m_sorted, hint);
    watch(*line);
    return line;
}

void LinkedTable::filterBy(const QLineEdit& line) {
    connect(&line, &QLineEdit::textChanged, &m_sorted, &SortedRows::setWords);
    watch(line);
}

/// Behind what filters: what is marked is shown in the rows that are left.
void LinkedTable::watch(const QLineEdit& line) {
    connect(&line, &QLineEdit::textChanged, this, [this] {
        showMarked();
        emit filtered();
    });
}

void LinkedTable::mark(std::vector<int> rows) {
    m_marked = std::move(rows);
    showMarked();
    if (m_follows) {
        scrollToMarked();
    }
}

void LinkedTable::showMarked() {
    const QScopedValueRollback guard(m_isMarking, true);
    std::vector<int> shown;
    for (const int row : m_marked) {
        const QModelIndex at = m_sorted.mapFromSource(m_sorted.sourceModel()->index(row, 0));
        if (at.isValid()) {
            shown.push_back(at.row());
        }
    }
    std::ranges::sort(shown);
    QItemSelection rows;
    const int last = m_sorted.columnCount() - 1;
    for (std::size_t at = 0; at < shown.size();) {  // rows that follow each other become one range
        const std::size_t first = at++;
        while (at < shown.size() && shown[at] == shown[at - 1] + 1) {
            ++at;
        }
        rows.select(m_sorted.index(shown[first], 0), m_sorted.index(shown[at - 1], last));
    }
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

std::vector<int> LinkedTable::shownRows() const {
    std::vector<int> rows;
    for (int row = 0; row < m_sorted.rowCount(); ++row) {
        rows.push_back(m_sorted.mapToSource(m_sorted.index(row, 0)).row());
    }
    return rows;
}

void LinkedTable::scrollToMarked() {
    const QModelIndexList rows = selectionModel()->selectedRows();
    if (rows.isEmpty()) {
        return;
    }
    const QModelIndex first = *std::ranges::min_element(rows, {}, &QModelIndex::row);
    goToRow(first);
}

void LinkedTable::takeSelected() {
    if (!m_isMarking && !m_sorted.isFiltering()) {
        m_marked = selectedRows();
        emit rowsSelected(m_marked);
    }
}

}  // namespace ui
