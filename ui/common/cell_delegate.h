#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// Paints and edits the cells of a TableModel by the traits of their columns: a box that a click toggles, a swatch of a
/// colour (what a click on it does is the panel's), a bar of percents that is dragged or typed, a choice of names.
/// Everything else is text. Where there is no room, bold text, that of headings, and numbers lose their end, whatever
/// the table has: the end of a number would read as another number.
class CellDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    /// The model has not taken the text that is in this editor.
    [[nodiscard]] static bool isRefused(const QWidget& editor);
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

protected:
    /// Enter in a choice takes it, and is not the dialog's too.
    bool eventFilter(QObject* editor, QEvent* event) override;
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    QPersistentModelIndex m_pressed;  ///< where the mouse button went down
};

}  // namespace ui
