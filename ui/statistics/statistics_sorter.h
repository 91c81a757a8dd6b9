#pragma once

#include <QSortFilterProxyModel>

namespace ui {

/// Sorts a StatisticsModel by number or by name; the row for all layers stays last whichever way it is sorted.
class StatisticsSorter : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit StatisticsSorter(QObject* parent = nullptr);

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

}  // namespace ui
