#include "ui/common/sorted_rows.h"

#include <QScopedValueRollback>
#include <algorithm>

namespace ui {

SortedRows::SortedRows(TableModel& model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
    const auto dropTexts = [this] { m_texts.clear(); };  // before this model hears of it
    connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, dropTexts);
    connect(&model, &QAbstractItemModel::dataChanged, this, dropTexts);
    connect(&model, &QAbstractItemModel::layoutAboutToBeChanged, this, dropTexts);
    connect(&model, &QAbstractItemModel::rowsInserted, this, dropTexts);
    connect(&model, &QAbstractItemModel::rowsRemoved, this, dropTexts);
    connect(&model, &QAbstractItemModel::rowsMoved, this, dropTexts);
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

void SortedRows::multiData(const QModelIndex& index, QModelRoleDataSpan roles) const {
    m_model.multiData(mapToSource(index), roles);
}

bool SortedRows::filterAcceptsRow(int row, const QModelIndex&) const {
    if (m_words.isEmpty() || m_model.rankOf(row) < m_leastRank) {
        return m_model.rankOf(row) >= m_leastRank;
    }
    const QString& text = textOf(row);
    return std::ranges::all_of(m_words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

const QString& SortedRows::textOf(int row) const {
    m_texts.resize(static_cast<std::size_t>(m_model.rowCount()));
    QString& text = m_texts[static_cast<std::size_t>(row)];
    if (text.isNull()) {
        text = m_model.searchText(row);
    }
    return text;
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
