#pragma once

#include <QTableView>
#include <vector>

class QLayout;

namespace ui {

/// A table that looks and copies alike in all panels: whole rows, no grid, Ctrl+C and a context menu that put rows on
/// the clipboard as tab-separated text.
class TableView : public QTableView {
    Q_OBJECT

public:
    explicit TableView(QWidget* parent = nullptr);

    /// A click into these columns does what their cells do and leaves the selection as it is.
    void setButtonColumns(std::vector<int> columns) { m_buttonColumns = std::move(columns); }
    void copySelection() const;
    void copyAll() const;

signals:
    void enterPressed(const QModelIndex& current);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                       const QEvent* event) const override;

private:
    std::vector<int> m_buttonColumns;
};

/// A panel of one table under one row of controls.
void layOut(QWidget& panel, QLayout* controls, TableView* table);

}  // namespace ui
