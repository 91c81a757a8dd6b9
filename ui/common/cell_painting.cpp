#include "ui/common/cell_painting.h"

#include <QApplication>
#include <algorithm>

namespace ui {

QRect innerOf(const QRect& cell) {
    return cell.adjusted(4, 3, -4, -3);
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
    const QStyle& style = option.widget != nullptr ? *option.widget->style() : *QApplication::style();
    style.drawPrimitive(QStyle::PE_PanelItemViewItem, &option, &painter, option.widget);
}

void paintSwatch(QPainter& painter, const QStyleOptionViewItem& option, const QColor& colour) {
    if (colour.isValid()) {
        painter.fillRect(innerOf(option.rect), colour);
    }
    painter.setPen(option.palette.color(QPalette::Mid));
    painter.drawRect(innerOf(option.rect).adjusted(0, 0, -1, -1));
}

void paintCheck(QPainter& painter, const QStyleOptionViewItem& option, bool isChecked) {
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QColor tone = option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    const double side = std::min(innerOf(option.rect).height(), innerOf(option.rect).width());
    QRectF box(0.0, 0.0, side, side);
    box.moveCenter(QRectF(option.rect).center());
    painter.setRenderHint(QPainter::Antialiasing);
    QColor faint = tone;
    faint.setAlpha(110);
    painter.setPen(QPen(faint, 1.0));
    painter.drawRoundedRect(box, 2.0, 2.0);
    if (isChecked) {
        const auto at = [&](double x, double y) { return box.topLeft() + QPointF(x, y) * side; };
        painter.setPen(QPen(tone, side / 7.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF{at(0.22, 0.52), at(0.42, 0.74), at(0.78, 0.28)});
    }
}

}  // namespace ui
