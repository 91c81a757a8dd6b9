#include "ui/section/section_pdf.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include "ui/workspace/feature.h"

namespace ui {

namespace {

constexpr int kDotsPerInch = 1200;
constexpr double kMmPerInch = 25.4;
constexpr double kStroke = 0.15;  // mm
constexpr double kArrow = 1.6;

void paintArrow(QPainter& painter, QPointF tip, QPointF from) {
    const double length = std::max(QLineF(tip, from).length(), 1e-9);
    const QPointF ahead = (from - tip) * (kArrow / length);
    const QPointF across(-ahead.y() / 4, ahead.x() / 4);
    painter.drawPolygon(QPolygonF{tip, tip + ahead + across, tip + ahead - across});
}

void paint(QPainter& painter, const model::SheetLine& line) {
    const QPointF from(line.x0, line.y0);
    const QPointF to(line.x1, line.y1);
    painter.setPen(QPen(Qt::black, kStroke, line.isDashed ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(from, to);
    if (line.hasArrows) {
        painter.setBrush(Qt::black);
        paintArrow(painter, from, to);
        paintArrow(painter, to, from);
    }
}

/// Fonts have whole sizes: letters are drawn large and made smaller.
void paint(QPainter& painter, const model::SheetText& text, double size) {
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

void paint(QPainter& painter, const model::SectionSheet& sheet) {
    for (const model::SheetPolygon& polygon : sheet.polygons) {
        QPolygonF corners;
        for (const auto& [x, y] : polygon.corners) {
            corners += QPointF(x, y);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor::fromRgb(polygon.fill));
        painter.drawPolygon(corners);
    }
    for (const model::SheetLine& line : sheet.lines) {
        paint(painter, line);
    }
    for (const model::SheetText& text : sheet.texts) {
        paint(painter, text, sheet.fontSize);
    }
}

}  // namespace

base::Status writeSectionPdf(const model::SectionSheet& sheet, const QString& title, const QString& path) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setTitle(title);
        writer.setResolution(kDotsPerInch);
        writer.setPageSize(
            QPageSize(QSizeF(sheet.width, sheet.height), QPageSize::Millimeter, {}, QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter);
        QPainter painter(&writer);
        painter.scale(kDotsPerInch / kMmPerInch, kDotsPerInch / kMmPerInch);
        paint(painter, sheet);
    }
    return writeFile(path, buffer.data());
}

}  // namespace ui
