#pragma once

#include "ui/common/table_view.h"

class QLineEdit;

namespace ui {

/// A table whose selected rows are what is chosen elsewhere, both ways. What is typed into its filter, and how it is
/// sorted, changes neither.
class LinkedTable : public TableView {
    Q_OBJECT

public:
    explicit LinkedTable(TableModel& model, QWidget* parent = nullptr);

    /// A line that filters its rows.
    [[nodiscard]] QLineEdit* makeFilter(const QString& hint);
    /// The same with the line of another table.
    void filterBy(const QLineEdit& line);
    /// Whether it scrolls to the first of the rows that are marked.
    void setFollows(bool isOn) { m_follows = isOn; }
    /// Selects these rows of the model, as far as the filter leaves them, and says nothing of it.
    void mark(std::vector<int> rows);
    /// Rows of the model that the filter leaves, in the order they are shown.
    [[nodiscard]] std::vector<int> shownRows() const;

signals:
    /// By mouse or keys; rows of the model.
    void rowsSelected(const std::vector<int>& rows);
    /// The filter leaves other rows.
    void filtered();

private:
    void watch(const QLineEdit& filter);
    void showMarked();
    void scrollToMarked();
    void takeSelected();

    SortedRows& m_sorted;
    std::vector<int> m_marked;
    bool m_follows = true;
    bool m_isMarking = false;
};

}  // namespace ui
