#include "ui/layer_delegate.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QSpinBox>
#include <algorithm>

#include "ui/models/layer_model.h"

namespace ui {

namespace {

using models::LayerModel;

QRect inner(const QRect& cell) {
    return cell.adjusted(4, 3, -4, -3);
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
    const QStyle& style = option.widget != nullptr ? *option.widget->style() : *QApplication::style();
    style.drawPrimitive(QStyle::PE_PanelItemViewItem, &option, &painter, option.widget);
}

void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, const QColor& colour) {
    painter.fillRect(inner(option.rect), colour);
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawRect(inner(option.rect).adjusted(0, 0, -1, -1));
}

void paintOpacity(QPainter& painter, const QStyleOptionViewItem& option, int percent) {
    const QRect whole = inner(option.rect);
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

int percentAt(const QRect& cell, double x) {
    const QRect whole = inner(cell);
    return std::clamp(static_cast<int>((x - whole.left()) * 100.0 / std::max(whole.width() - 1, 1)), 0, 100);
}

}  // namespace

void LayerDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    if (index.column() != LayerModel::Colour && index.column() != LayerModel::Opacity) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    painter->save();
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    paintGround(*painter, cell);
    if (index.column() == LayerModel::Colour) {
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
    if (index.column() == LayerModel::Opacity && (isPress || event->type() == QEvent::MouseMove)) {
        const auto& mouse = static_cast<const QMouseEvent&>(*event);
        if (mouse.buttons().testFlag(Qt::LeftButton)) {
            return model->setData(index, percentAt(option.rect, mouse.position().x()), Qt::EditRole);
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace ui
