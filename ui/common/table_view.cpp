#include "ui/common/table_view.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "ui/common/cell_delegate.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_text.h"

namespace ui {

namespace {

/// Of longer tables so many rows are read to find how wide a column has to be, evenly spread, and of these one in so
/// many is measured whatever it says.
constexpr int kReadRows = 1'000;
constexpr int kMeasuredOneIn = 5;

/// Then other events have their turn.
constexpr int kMeasureMs = 8;

}  // namespace

TableView::TableView(TableModel& model, QWidget* parent) : QTableView(parent) {
    setModel(&model);
    setItemDelegate(new CellDelegate(this));
    setEditTriggers(EditKeyPressed | DoubleClicked);
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
    connect(this, &QTableView::clicked, this, &TableView::choose);
    connect(this, &TableView::enterPressed, this, &TableView::choose);
    m_measuring.setSingleShot(true);
    connect(&m_measuring, &QTimer::timeout, this, &TableView::measure);
}

SortedRows& TableView::makeSortable() {
    auto* rows = new SortedRows(static_cast<TableModel&>(*model()), this);
    setModel(rows);
    horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    setSortingEnabled(true);
    // Who sorts wants the first rows, wherever the current one goes.
    connect(horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &QTableView::scrollToTop);
    return *rows;
}

void TableView::fitColumns(int stretched) {
    m_stretched = stretched;
    connect(model(), &QAbstractItemModel::modelReset, this, [this] {
        m_isFitDue = true;
        measureSoon();
    });
    fit();
}

void TableView::keepNumbersWhole() {
    m_keepsNumbersWhole = true;
    const auto widenSoon = [this] {
        m_toWiden = 0;
        measureSoon();
    };
    connect(model(), &QAbstractItemModel::modelReset, this, widenSoon);
    connect(model(), &QAbstractItemModel::dataChanged, this, widenSoon);
    widenSoon();
}

void TableView::measureSoon() {
    if (isVisible()) {
        m_measuring.start(0);
    }
}

void TableView::measure() {
    QElapsedTimer clock;
    clock.start();
    while (isVisible() && measureNext()) {
        if (clock.elapsed() >= kMeasureMs) {
            m_measuring.start(0);
            return;
        }
    }
}

bool TableView::measureNext() {
    if (std::exchange(m_isFitDue, false)) {
        fit();
        return true;
    }
    if (m_keepsNumbersWhole && m_toWiden < model()->columnCount()) {
        widen(m_toWiden++);
        return true;
    }
    return false;
}

void TableView::fit() {
    for (int column = 0; column < model()->columnCount(); ++column) {
        if (column != m_stretched) {
            resizeColumnToContents(column);
        }
    }
    if (m_stretched >= 0) {
        horizontalHeader()->setSectionResizeMode(m_stretched, QHeaderView::Stretch);
        leaveRoom();
    }
}

int TableView::sizeHintForColumn(int column) const {
    const int rows = model()->rowCount();
    if (rows <= kReadRows / kMeasuredOneIn) {
        return QTableView::sizeHintForColumn(column);
    }
    int width = 0;
    qsizetype longest = -1;
    for (int row = 0, count = 0; row < rows; row += rows / kReadRows + 1, ++count) {
        const QModelIndex index = model()->index(row, column);
        const qsizetype length = index.data().toString().size();
        if (length > longest || count % kMeasuredOneIn == 0) {
            width = std::max(width, sizeHintForIndex(index).width());
            longest = std::max(longest, length);
        }
    }
    return width;
}

/// The stretched column is what the table is about: where others leave it less than half of the room, none of them
/// takes more than a third.
void TableView::leaveRoom() {
    const int room = viewport()->width();
    int taken = 0;
    for (int column = 0; column < model()->columnCount(); ++column) {
        taken += column != m_stretched && !isColumnHidden(column) ? columnWidth(column) : 0;
    }
    for (int column = 0; taken > room / 2 && column < model()->columnCount(); ++column) {
        if (column != m_stretched && columnWidth(column) > room / 3) {
            setColumnWidth(column, room / 3);
        }
    }
}

void TableView::widen(int column) {
    const QVariant traits = model()->index(0, column).data(TableModel::kTraitsRole);  // none while there are no rows
    const int heading = horizontalHeader()->sectionSizeHint(column);
    const int needed = (traits.toInt() & kNumber) != 0 ? std::max(heading, sizeHintForColumn(column) + 1) : heading;
    if (!isColumnHidden(column) && columnWidth(column) < needed) {
        setColumnWidth(column, needed);
    }
}

void TableView::showEvent(QShowEvent* event) {
    QTableView::showEvent(event);
    measure();
}

/// The sizes are those of the viewport.
void TableView::resizeEvent(QResizeEvent* event) {
    const QRect row = visualRect(currentIndex());
    const int before = event->oldSize().height();
    const bool wasInSight = row.isValid() && row.bottom() >= 0 && row.top() < before;
    QTableView::resizeEvent(event);
    if (wasInSight && event->size().height() < before) {
        goToRow(currentIndex());
    }
}

void TableView::goToRow(const QModelIndex& index) {
    const int before = horizontalScrollBar()->value();
    selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    scrollTo(index);
    horizontalScrollBar()->setValue(before);
}

/// A while after a click Qt brings all of the clicked cell into sight.
void TableView::timerEvent(QTimerEvent* event) {
    const int before = horizontalScrollBar()->value();
    QTableView::timerEvent(event);
    horizontalScrollBar()->setValue(before);
}

/// Keys that go up and down do not move it sideways.
void TableView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    const int before = horizontalScrollBar()->value();
    QTableView::currentChanged(current, previous);
    if (current.column() == previous.column()) {
        horizontalScrollBar()->setValue(before);
    }
}

QAction& TableView::addDelete(const QString& tip) {
    QAction* action = addAction(tr("Delete"), QKeySequence(QKeySequence::Delete), this, [this] {
        if (const std::vector<int> rows = selectedRows(); !rows.empty()) {
            emit deleteRequested(rows);
        }
    });
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setToolTip(tip);
    return *action;
}

int TableView::rowOf(const QModelIndex& index) const {
    const auto* rows = qobject_cast<const QAbstractProxyModel*>(model());
    return rows != nullptr ? rows->mapToSource(index).row() : index.row();
}

std::vector<int> TableView::selectedRows() const {
    std::vector<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows()) {
        rows.push_back(rowOf(index));
    }
    return rows;
}

void TableView::choose(const QModelIndex& index) {
    if (index.isValid()) {
        emit rowChosen(rowOf(index));
    }
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

void TableView::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    const bool isLeft = hint == QAbstractItemDelegate::RevertModelCache || !editor->hasFocus();
    if (isLeft || !CellDelegate::isRefused(*editor)) {
        QTableView::closeEditor(editor, hint);
    }
}

bool TableView::isTyped(const QKeyEvent& event) const {
    const bool isPlain = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    const bool isText = isPlain && !event.text().isEmpty() && event.text().front().isPrint();
    return isText && editTriggers().testFlag(AnyKeyPressed) && currentIndex().flags().testFlag(Qt::ItemIsEditable);
}

bool TableView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isTyped(static_cast<const QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

/// Qt leaves the current cell where it is if the delegate takes the press for itself.
bool TableView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    const QPersistentModelIndex cell(index);
    const bool isTaken = QTableView::edit(index, trigger, event);
    const bool isPress = event != nullptr && event->type() == QEvent::MouseButtonPress;
    if (isTaken && isPress && (cell.data(TableModel::kTraitsRole).toInt() & kPercent) != 0) {
        const bool scrolls = hasAutoScroll();
        setAutoScroll(false);  // it stays under the mouse
        selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
        setAutoScroll(scrolls);
    }
    return isTaken;
}

void TableView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        const bool isOfEditor = isEditing();  // which ends by it, and hands it on
        QTableView::keyPressEvent(event);     // an editable cell opens its editor
        if (!isOfEditor) {
            emit enterPressed(currentIndex());
        }
    } else {
        QTableView::keyPressEvent(event);
    }
}

void TableView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu;
    menu.addActions(actions());
    addCopying(menu);
    menu.exec(event->globalPos());
}

void TableView::addCopying(QMenu& menu) {
    menu.addSeparator();
    QAction* copy = menu.addAction(tr("Co&py rows\tCtrl+C"), this, &TableView::copySelection);
    copy->setEnabled(selectionModel() != nullptr && selectionModel()->hasSelection());
    menu.addAction(tr("Copy &all with headings"), this, &TableView::copyAll);
}

QItemSelectionModel::SelectionFlags TableView::selectionCommand(const QModelIndex& index, const QEvent* event) const {
    const bool isMouse = dynamic_cast<const QMouseEvent*>(event) != nullptr;
    const bool isButton = std::ranges::find(m_buttonColumns, index.column()) != m_buttonColumns.end();
    return isMouse && isButton ? QItemSelectionModel::NoUpdate : QTableView::selectionCommand(index, event);
}

}  // namespace ui
