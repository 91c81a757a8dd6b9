#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/comparison/comparison_model.h"
#include "ui/workspace/actions.h"

namespace ui {

class SortedRows;
class TableView;

/// The list of differences with a line to filter it by, the commands that compare, and what was found.
class ComparisonPanel : public QWidget {
    Q_OBJECT

public:
    ComparisonPanel(ComparisonModel& differences, const ActionSet& actions, QWidget* parent = nullptr);

    /// Rows of the model in the order of the list, without those that are filtered out; the first of them.
    [[nodiscard]] std::vector<int> listedRows(std::size_t most) const;

signals:
    /// By a click, Enter, or an arrow key that came to it.
    void rowChosen(int row);
    /// `listedRows` may be others.
    void listed();

private:
    [[nodiscard]] TableView* makeTable();
    [[nodiscard]] QLayout* makeControls(const ActionSet& actions);

    ComparisonModel& m_differences;
    SortedRows* m_rows = nullptr;
    QTimer m_listing;  ///< a filter takes rows away one after the other
};

}  // namespace ui
