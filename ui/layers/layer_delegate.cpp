#include "ui/layers/layer_delegate.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSpinBox>
#include <algorithm>

#include "ui/common/cell_painting.h"
#include "ui/layers/layer_model.h"

namespace ui {

namespace {

void paintOpacity(QPainter& painter, const QStyleOptionViewItem& option, int percent) {
    const QRect whole = innerOf(option.rect);
    QRect filled = whole;
    filled.setWidth(whole.width() * percent / 100);
    QColor tone = option.palette.color(QPalette::Text);
    tone.setAlpha(45);
    painter.fillRect(filled, tone);
    tone.setAlpha(110);
    painter.setPen(tone);
    painter.drawRect(whole.adjusted(0, 0, -1, -1));
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    painter.setPen(option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    painter.drawText(whole, Qt::AlignCenter, QStringLiteral("%1 %").arg(percent));
}

bool isCheckColumn(int column) {
    return column == LayerModel::Visible || column == LayerModel::Solo;
}

int percentAt(const QRect& cell, double x) {
    const QRect whole = innerOf(cell);
    return std::clamp(static_cast<int>((x - whole.left()) * 100.0 / std::max(whole.width() - 1, 1)), 0, 100);
}

}  // namespace

void LayerDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int column = index.column();
    if (column == LayerModel::Name || column == LayerModel::Type) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    painter->save();
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    paintGround(*painter, cell);
    if (isCheckColumn(column)) {
        paintCheck(*painter, cell, index.data(Qt::CheckStateRole).toInt() == Qt::Checked);
    } else if (column == LayerModel::Colour) {
        paintSwatch(*painter, cell, index.data(Qt::EditRole).value<QColor>());
    } else {
        paintOpacity(*painter, cell, index.data(Qt::EditRole).toInt());
    }
    painter->restore();
}

QWidget* LayerDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    if (index.column() != LayerModel::Opacity) {
        return nullptr;
    }
    auto* box = new QSpinBox(parent);
    box->setRange(0, 100);
    box->setSuffix(QStringLiteral(" %"));
    box->setFrame(false);
    return box;
}

bool LayerDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
    const bool isPress = event->type() == QEvent::MouseButtonPress;
    const bool isDrag = event->type() == QEvent::MouseMove;
    const bool isMouse = isPress || isDrag || event->type() == QEvent::MouseButtonDblClick;
    if (!isMouse || !static_cast<const QMouseEvent&>(*event).buttons().testFlag(Qt::LeftButton)) {
        // The release after a press has done its work; keys go the usual way.
        return (event->type() == QEvent::MouseButtonRelease && isCheckColumn(index.column())) ||
               QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    if (isPress) {
        m_pressed = index;
    }
    // A drag that began elsewhere, to select rows say, changes nothing when it passes here.
    if (index.column() == LayerModel::Opacity && (isPress || (isDrag && index == m_pressed))) {
        const double x = static_cast<const QMouseEvent&>(*event).position().x();
        return model->setData(index, percentAt(option.rect, x), Qt::EditRole);
    }
    if (isCheckColumn(index.column()) && !isDrag) {
        const bool wasChecked = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
        return model->setData(index, wasChecked ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace ui
