#pragma once

#include <QTableView>

class QLayout;

namespace ui {

/// A table that looks and copies alike in all panels: whole rows, no grid, Ctrl+C and a context menu that put rows on
/// the clipboard as tab-separated text.
class TableView : public QTableView {
    Q_OBJECT

public:
    explicit TableView(QWidget* parent = nullptr);

    void copySelection() const;
    void copyAll() const;

signals:
    void enterPressed(const QModelIndex& current);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
};

/// A panel of one table under one row of controls.
void layOut(QWidget& panel, QLayout* controls, TableView* table);

}  // namespace ui
