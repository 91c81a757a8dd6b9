#include "ui/stackup/stackup_pdf.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include "model/export/stackup_sheet.h"
#include "ui/common/sheet_text.h"

namespace ui {

namespace {

constexpr int kDotsPerInch = 1200;
constexpr int kMarginMm = 12;
/// The sheet is not blown up beyond its own size (96 pixels per inch).
constexpr double kMostScale = kDotsPerInch / 96.0;

void paint(QPainter& painter, const model::SheetRect& rect) {
    painter.setPen(QPen(QColor::fromRgb(rect.edge), rect.edgeWidth));
    painter.setBrush(QColor::fromRgb(rect.fill));
    painter.drawRect(QRectF(rect.x, rect.y, rect.width, rect.height));
}

void paint(QPainter& painter, const model::SheetLeader& leader) {
    painter.setPen(QPen(QColor(0x88, 0x88, 0x88), 0.7));
    painter.drawPolyline(QPolygonF{
        {leader.x0, leader.y0}, {leader.x0 + 8, leader.y0}, {leader.x1 - 6, leader.y1}, {leader.x1, leader.y1}});
}

void paint(QPainter& painter, const model::StackupSheet& sheet) {
    for (const model::SheetRect& rect : sheet.rects) {
        paint(painter, rect);
    }
    for (const model::SheetLeader& leader : sheet.leaders) {
        paint(painter, leader);
    }
    for (const model::SheetText& text : sheet.texts) {
        paintSheetText(painter, text, sheet.fontSize);
    }
}

}  // namespace

base::Result<std::string> stackupPdf(const model::Document& document, bool isExaggerated,
                                     const model::LengthWriter& write) {
    const model::StackupSheet sheet = model::stackupSheet(document, isExaggerated, write);
    if (sheet.width <= 0.0) {
        return base::Error{base::ErrorCode::BadUsage,
                           "This board states its heights itself; there is no stackup to write"};
    }
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setTitle(QString::fromStdString(document.job.name));
        writer.setResolution(kDotsPerInch);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageOrientation(sheet.width > sheet.height ? QPageLayout::Landscape : QPageLayout::Portrait);
        writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
        QPainter painter(&writer);
        const double scale = std::min({kMostScale, writer.width() / sheet.width, writer.height() / sheet.height});
        painter.scale(scale, scale);
        paint(painter, sheet);
    }
    return buffer.data().toStdString();
}

}  // namespace ui
