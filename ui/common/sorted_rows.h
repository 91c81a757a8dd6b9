#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>
#include <vector>

#include "ui/common/table_model.h"

namespace ui {

/// The rows of a table by value, a row of totals last either way; those that hold all the words typed, in any order and
/// case, and are of a rank high enough.
class SortedRows : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit SortedRows(TableModel& model, QObject* parent = nullptr);

    void setWords(const QString& words);
    void setLeastRank(int rank);
    /// While rows come and go because of what is typed: a table then loses selected rows that the user did not
    /// deselect.
    [[nodiscard]] bool isFiltering() const { return m_isFiltering; }

    /// Qt's own asks for each role by itself.
    void multiData(const QModelIndex& index, QModelRoleDataSpan roles) const override;

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    void filterAnew();
    [[nodiscard]] const QString& textOf(int row) const;

    TableModel& m_model;
    QStringList m_words;
    mutable std::vector<QString> m_texts;  ///< by row, what is searched: made when it is wanted, until it changes
    int m_leastRank = 0;
    bool m_isFiltering = false;
};

}  // namespace ui
