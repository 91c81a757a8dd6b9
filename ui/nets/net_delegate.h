#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// The cells of the Nets panel that are no text: a field for the colour of a net, a box for whether it is shown. A
/// click turns the box; what a click on a colour does is the panel's.
class NetDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
};

}  // namespace ui
