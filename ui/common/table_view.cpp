#include "ui/common/table_view.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/common/table_text.h"

namespace ui {

TableView::TableView(QWidget* parent) : QTableView(parent) {
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);  // Tab leaves the table, as everywhere else
    setHorizontalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void TableView::copySelection() const {
    const QModelIndexList cells = selectedIndexes();
    if (!cells.isEmpty()) {
        QGuiApplication::clipboard()->setText(rowsText(cells));
    }
}

void TableView::copyAll() const {
    QGuiApplication::clipboard()->setText(tableText(*model()));
}

void TableView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        QTableView::keyPressEvent(event);  // an editable cell opens its editor
        emit enterPressed(currentIndex());
    } else {
        QTableView::keyPressEvent(event);
    }
}

void TableView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu;
    QAction* copy = menu.addAction(QStringLiteral("&Copy rows\tCtrl+C"), this, &TableView::copySelection);
    copy->setEnabled(selectionModel() != nullptr && selectionModel()->hasSelection());
    menu.addAction(QStringLiteral("Copy &all with headings"), this, &TableView::copyAll);
    menu.exec(event->globalPos());
}

QItemSelectionModel::SelectionFlags TableView::selectionCommand(const QModelIndex& index, const QEvent* event) const {
    const bool isMouse = dynamic_cast<const QMouseEvent*>(event) != nullptr;
    const bool isButton = std::ranges::find(m_buttonColumns, index.column()) != m_buttonColumns.end();
    return isMouse && isButton ? QItemSelectionModel::NoUpdate : QTableView::selectionCommand(index, event);
}

void layOut(QWidget& panel, QLayout* controls, TableView* table) {
    auto* layout = new QVBoxLayout(&panel);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    layout->addLayout(controls);
    layout->addWidget(table);
}

}  // namespace ui
