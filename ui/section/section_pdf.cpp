#include "ui/section/section_pdf.h"

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>

#include "ui/common/sheet_text.h"

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

void paint(QPainter& painter, const model::SectionSheet& sheet) {
    for (const model::SheetPolygon& polygon : sheet.polygons) {
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const auto& contour : polygon.contours) {
            QPolygonF corners;
            for (const auto& [x, y] : contour) {
                corners += QPointF(x, y);
            }
            path.addPolygon(corners);
            path.closeSubpath();
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor::fromRgb(polygon.fill));
        painter.drawPath(path);
    }
    for (const model::SheetLine& line : sheet.lines) {
        paint(painter, line);
    }
    for (const model::SheetText& text : sheet.texts) {
        paintSheetText(painter, text, sheet.fontSize);
    }
}

}  // namespace

std::string sectionPdf(const model::SectionSheet& sheet, const QString& title) {
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
    return buffer.data().toStdString();
}

}  // namespace ui
