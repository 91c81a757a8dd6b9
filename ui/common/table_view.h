#pragma once

#include <QTableView>
#include <QTimer>
#include <vector>

class QMenu;

namespace ui {

class SortedRows;
class TableModel;

/// A table that looks and copies alike in all panels: whole rows, no grid, Ctrl+C and a context menu that put rows on
/// the clipboard as tab-separated text. Before that the menu has the actions that were added to the table. Rows are
/// those of the TableModel, however they are sorted.
class TableView : public QTableView {
    Q_OBJECT

public:
    explicit TableView(TableModel& model, QWidget* parent = nullptr);

    /// From now on a click on a heading sorts; until then rows are in the order of the model.
    SortedRows& makeSortable();
    /// Columns are as wide as their cells after every reset; `stretched` takes the room that is left, none: -1. Where
    /// that is little, what is wide is cut for it.
    void fitColumns(int stretched = -1);
    /// Columns are never narrower than their headings, those of numbers never narrower than these: they grow when rows
    /// come and when cells change, and shrink only by hand.
    void keepNumbersWhole();
    /// A click into these columns does what their cells do and leaves the selection as it is.
    void setButtonColumns(std::vector<int> columns) { m_buttonColumns = std::move(columns); }
    /// A command that deletes the selected rows, also with Del.
    QAction& addDelete(const QString& tip);
    [[nodiscard]] std::vector<int> selectedRows() const;
    void choose(const QModelIndex& index);
    /// Makes it the current one and scrolls to its row. Not sideways: what lies to the left stays in sight, as it does
    /// after clicks. A current row that is in sight stays so when the table becomes smaller.
    void goToRow(const QModelIndex& index);
    /// The editor of a cell is open. Keys that it does not take come here: they are not meant for the current row.
    [[nodiscard]] bool isEditing() const { return state() == EditingState; }
    using QTableView::edit;
    /// What every menu of a row ends with.
    void addCopying(QMenu& menu);
    void copySelection() const;
    void copyAll() const;

signals:
    /// Not by the Enter that ends an edit.
    void enterPressed(const QModelIndex& current);
    /// After a click on the row, Enter, or `choose`.
    void rowChosen(int row);
    void deleteRequested(const std::vector<int>& rows);

protected:
    /// What is typed into a cell whose editor any key opens is no command.
    bool event(QEvent* event) override;
    /// A bar of percents that is pressed becomes the current cell, as any other does: Enter is about it. The selection
    /// stays.
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    /// Reading a cell takes little, measuring it much: of long tables those with the longest texts are measured, and
    /// some of the others. Numbers are as wide as they are long.
    [[nodiscard]] int sizeHintForColumn(int column) const override;
    /// Gives columns the widths that their cells need once these are seen and what changes them is over: a board that
    /// is opened changes them several times. What takes longer than a part of a frame goes on after other events.
    void measureSoon();
    /// Does a piece of that. False: there is no more to do.
    [[nodiscard]] virtual bool measureNext();
    /// A text that the model has refused stays to be mended: Enter and Tab do not take it away, Esc and a click
    /// elsewhere do.
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void timerEvent(QTimerEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                       const QEvent* event) const override;

private:
    [[nodiscard]] bool isTyped(const QKeyEvent& event) const;
    [[nodiscard]] int rowOf(const QModelIndex& index) const;
    void fit();
    void leaveRoom();
    void measure();
    void widen(int column);

    int m_stretched = -1;
    bool m_isFitDue = false;
    bool m_keepsNumbersWhole = false;
    int m_toWiden = 0;  ///< the first column that may be too narrow
    QTimer m_measuring;
    std::vector<int> m_buttonColumns;
};

}  // namespace ui
