#include "ui/parts/linked_table.h"

#include <QHeaderView>
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

void LinkedTable::giveRoom(const std::vector<int>& columns) {
    m_spread = columns;
    for (int column = 0; column < model()->columnCount(); ++column) {
        m_leastWidths.push_back(columnWidth(column));
    }
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column, int before, int now) {
        if (m_isSpreading) {
            return;
        }
        if (before == 0 || now == 0) {  // shown or hidden
            measureSoon();
        } else if (std::ranges::find(m_spread, column) != m_spread.end()) {
            m_spread.clear();  // by hand
        }
    });
    connect(model(), &QAbstractItemModel::headerDataChanged, this, [this](Qt::Orientation, int first, int last) {
        for (int column = first; column <= last; ++column) {
            m_headingWidths[column] = horizontalHeader()->sectionSizeHint(column);
        }
        measureSoon();
    });
    connect(model(), &QAbstractItemModel::dataChanged, this, [this] { m_neededWidths.clear(); });
    connect(model(), &QAbstractItemModel::modelReset, this, [this] {
        m_neededWidths.clear();
        measureSoon();
    });
}

void LinkedTable::resizeEvent(QResizeEvent* event) {
    TableView::resizeEvent(event);
    spread();
}

bool LinkedTable::measureNext() {
    {
        const QScopedValueRollback guard(m_isSpreading, true);  // columns that grow for their headings do not by hand
        if (TableView::measureNext()) {
            return true;
        }
    }
    for (const int column : m_spread) {
        if (!isColumnHidden(column) && !m_neededWidths.contains(column)) {
            m_neededWidths[column] = sizeHintForColumn(column);
            return true;
        }
    }
    spread();
    return false;
}

/// Once it is seen and all that matter were measured.
void LinkedTable::spread() {
    if (!isVisible() || m_spread.empty()) {
        return;
    }
    const auto isMeasured = [&](int column) { return isColumnHidden(column) || m_neededWidths.contains(column); };
    if (!std::ranges::all_of(m_spread, isMeasured)) {
        measureSoon();
        return;
    }
    const QScopedValueRollback guard(m_isSpreading, true);
    int room = roomBehind();
    for (const int column : m_spread) {
        if (!isColumnHidden(column)) {
            const int least = leastWidthOf(column);
            const int more = std::clamp(m_neededWidths[column] - least, 0, std::max(room, 0));
            setColumnWidth(column, least + more);
            room -= more;
        }
    }
}

int LinkedTable::leastWidthOf(int column) const {
    const auto heading = m_headingWidths.find(column);
    return std::max(m_leastWidths[static_cast<std::size_t>(column)],
                    heading != m_headingWidths.end() ? heading->second : 0);
}

/// If the columns that take it had their least widths, and the last one, which always ends with the table, its own.
int LinkedTable::roomBehind() const {
    const QHeaderView& header = *horizontalHeader();
    int room = viewport()->width();
    bool isLast = true;
    for (int place = header.count() - 1; place >= 0; --place) {
        const int column = header.logicalIndex(place);
        if (isColumnHidden(column)) {
            continue;
        }
        const bool takes = std::ranges::find(m_spread, column) != m_spread.end();
        const int least = leastWidthOf(column);
        room -= takes ? least : isLast ? std::max(least, header.sectionSizeHint(column)) : columnWidth(column);
        isLast = false;
    }
    return room;
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
