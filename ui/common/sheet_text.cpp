#include "ui/common/sheet_text.h"

#include <QPainter>

namespace ui {

void paintSheetText(QPainter& painter, const model::SheetText& text, double size) {
    constexpr int kLetterPixels = 100;
    QFont font = painter.font();
    font.setPixelSize(kLetterPixels);
    font.setBold(text.isBold);
    font.setItalic(text.isItalic);
    painter.save();
    painter.translate(text.x, text.y);
    painter.scale(size / kLetterPixels, size / kLetterPixels);
    painter.setFont(font);
    painter.setPen(Qt::black);
    const QString words = QString::fromStdString(text.text);
    const double width = painter.fontMetrics().horizontalAdvance(words);
    const double back = text.align == model::SheetAlign::Left     ? 0.0
                        : text.align == model::SheetAlign::Middle ? 0.5
                                                                  : 1.0;
    painter.drawText(QPointF(-back * width, 0.0), words);
    painter.restore();
}

}  // namespace ui
