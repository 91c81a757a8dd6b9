#pragma once

#include <map>

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
    /// Where there is room behind the last column, these take it in this order, as far as their cells need it: names
    /// are not cut while half of the table is empty. Until the user sets a width of theirs.
    void giveRoom(const std::vector<int>& columns);
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

protected:
    void resizeEvent(QResizeEvent* event) override;
    [[nodiscard]] bool measureNext() override;

private:
    void spread();
    [[nodiscard]] int roomBehind() const;
    [[nodiscard]] int leastWidthOf(int column) const;
    void watch(const QLineEdit& filter);
    void showMarked();
    void scrollToMarked();
    void takeSelected();

    SortedRows& m_sorted;
    std::vector<int> m_marked;
    std::vector<int> m_spread;           ///< columns that take what room there is
    std::vector<int> m_leastWidths;      ///< of all columns
    std::map<int, int> m_headingWidths;  ///< of headings that were replaced since
    std::map<int, int> m_neededWidths;   ///< of those of m_spread that were measured, for their cells
    bool m_isSpreading = false;
    bool m_follows = true;
    bool m_isMarking = false;
};

}  // namespace ui
