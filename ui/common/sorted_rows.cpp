#include "ui/common/sorted_rows.h"

#include <QScopedValueRollback>
#include <algorithm>

namespace ui {

SortedRows::SortedRows(TableModel& model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
    setSourceModel(&model);
    setSortRole(TableModel::kSortRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

void SortedRows::setWords(const QString& words) {
    m_words = words.split(' ', Qt::SkipEmptyParts);
    filterAnew();
}

void SortedRows::setLeastRank(int rank) {
    m_leastRank = rank;
    filterAnew();
}

void SortedRows::filterAnew() {
    const QScopedValueRollback guard(m_isFiltering, true);
    invalidateFilter();
}

bool SortedRows::filterAcceptsRow(int row, const QModelIndex&) const {
    if (m_words.isEmpty() || m_model.rankOf(row) < m_leastRank) {
        return m_model.rankOf(row) >= m_leastRank;
    }
    const QString text = m_model.searchText(row);
    return std::ranges::all_of(m_words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool SortedRows::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const bool isLeftTotal = m_model.isTotal(left.row());
    const bool isRightTotal = m_model.isTotal(right.row());
    if (isLeftTotal || isRightTotal) {
        // A descending sort swaps the operands, so the result depends on the direction for the row to stay last.
        return sortOrder() == Qt::AscendingOrder ? isRightTotal && !isLeftTotal : isLeftTotal && !isRightTotal;
    }
    return QSortFilterProxyModel::lessThan(left, right);
}

}  // namespace ui
