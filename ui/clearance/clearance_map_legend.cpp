#include "ui/clearance/clearance_map_legend.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "render/scene/colour_ramp.h"

namespace ui {

namespace {

constexpr double kMargin = 8.0;
constexpr double kPadding = 7.0;
constexpr double kBarWidth = 14.0;
constexpr double kBarHeight = 130.0;
constexpr double kTick = 4.0;
constexpr double kLeastView = 2.0;  ///< times as large as the legend
constexpr QColor kGround(24, 26, 31, 225);
constexpr QColor kInk(225, 228, 233);
constexpr double kMostNumbers = 5.0;

void paintBar(QPainter& painter, const QRectF& bar) {
    for (int y = 0; y < static_cast<int>(bar.height()); ++y) {
        const glm::vec3 c = render::rampColour(static_cast<float>(y / bar.height())) * 255.0F;
        painter.fillRect(QRectF(bar.left(), bar.top() + y, bar.width(), 1.0),
                         QColor(qRound(c.r), qRound(c.g), qRound(c.b)));
    }
}

void paintMark(QPainter& painter, const QRectF& bar, double at) {
    const double y = bar.top() + at * bar.height();
    QPainterPath arrow(QPointF(bar.left() - 1, y));
    arrow.lineTo(bar.left() - 7, y - 4);
    arrow.lineTo(bar.left() - 7, y + 4);
    arrow.closeSubpath();
    painter.fillPath(arrow, kInk);
    painter.fillRect(QRectF(bar.left(), y - 1, bar.width(), 2), kInk);
}

}  // namespace

std::vector<double> ClearanceMapLegend::numbers() const {
    const double most = reach / nmPer(unit);
    const double power = std::pow(10.0, std::floor(std::log10(most / kMostNumbers)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0}) {
        step = most / (factor * power) <= kMostNumbers + 1e-9 ? factor * power : step;
    }
    std::vector<double> values;
    for (double value = 0.0; value < most - 0.6 * step; value += step) {  // the last one leaves room for the end
        values.push_back(value * nmPer(unit));
    }
    values.push_back(reach);
    return values;
}

QRectF ClearanceMapLegend::place(const QFont& font, QSizeF canvas) const {
    const QFontMetricsF metrics(font);
    double widest = 0.0;
    for (const double value : numbers()) {
        widest = std::max(widest, metrics.horizontalAdvance(lengthText(value, unit)));
    }
    const double width = std::max(metrics.horizontalAdvance(title), kTick * 4 + kBarWidth + widest) + 2 * kPadding;
    const double height = metrics.height() * 2 + kBarHeight + 2 * kPadding;
    const bool hasRoom = canvas.width() >= kLeastView * width && canvas.height() >= kLeastView * height;
    return hasRoom ? QRectF(canvas.width() - width - kMargin, canvas.height() - height - kMargin, width, height)
                   : QRectF();
}

void ClearanceMapLegend::paint(QPainter& painter, QSizeF canvas) const {
    const QFontMetricsF metrics(painter.font());
    const QRectF box = place(painter.font(), canvas);
    if (box.isEmpty()) {
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(kInk);
    painter.drawText(QPointF(box.left() + kPadding, box.top() + kPadding + metrics.ascent()), title);
    const QRectF bar(box.left() + kPadding + 2 * kTick, box.top() + kPadding + metrics.height() * 1.5, kBarWidth,
                     kBarHeight);
    paintBar(painter, bar);
    for (const double value : numbers()) {
        const double y = bar.top() + value / reach * bar.height();
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + kTick, y));
        painter.drawText(QPointF(bar.right() + 2 * kTick, y + metrics.capHeight() / 2), lengthText(value, unit));
    }
    if (mark && *mark > 0.0 && *mark <= reach) {
        paintMark(painter, bar, *mark / reach);
    }
}

}  // namespace ui
