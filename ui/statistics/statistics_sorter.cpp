#include "ui/statistics/statistics_sorter.h"

#include "ui/statistics/statistics_model.h"

namespace ui {

StatisticsSorter::StatisticsSorter(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(Qt::EditRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

bool StatisticsSorter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const auto* statistics = qobject_cast<const StatisticsModel*>(sourceModel());
    const bool isLeftTotal = statistics != nullptr && statistics->isTotal(left.row());
    const bool isRightTotal = statistics != nullptr && statistics->isTotal(right.row());
    if (isLeftTotal || isRightTotal) {
        // A descending sort swaps the operands, so the answer has to know the direction for the row to stay last.
        return sortOrder() == Qt::AscendingOrder ? isRightTotal && !isLeftTotal : isLeftTotal && !isRightTotal;
    }
    return QSortFilterProxyModel::lessThan(left, right);
}

}  // namespace ui
