#include "ui/nets/net_delegate.h"

#include <QMouseEvent>

#include "ui/common/cell_painting.h"
#include "ui/nets/net_model.h"

namespace ui {

void NetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const bool isShown = index.column() == NetModel::Shown;
    if (!isShown && index.column() != NetModel::Colour) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    painter->save();
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    paintGround(*painter, cell);
    if (isShown) {
        paintCheck(*painter, cell, index.data(Qt::CheckStateRole).toInt() == Qt::Checked);
    } else {
        paintSwatch(*painter, cell, index.data(Qt::EditRole).value<QColor>());
    }
    painter->restore();
}

bool NetDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                              const QModelIndex& index) {
    const bool isMouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick ||
                         event->type() == QEvent::MouseButtonRelease;
    if (index.column() != NetModel::Shown || !isMouse) {
        return QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    if (event->type() == QEvent::MouseButtonRelease ||
        static_cast<const QMouseEvent&>(*event).button() != Qt::LeftButton) {
        return true;
    }
    const bool wasShown = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return model->setData(index, wasShown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

}  // namespace ui
