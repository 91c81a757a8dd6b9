#include "ui/measurement_painter.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <cmath>

#include "ui/models/measurement_model.h"

namespace ui {

using model::SnapKind;
using model::session::MeasuredEnd;
using model::session::Measurement;

namespace {

constexpr QColor kLineColour(255, 205, 70);
constexpr QColor kUnderColour(0, 0, 0, 200);
constexpr QColor kLabelColour(20, 22, 26, 215);
constexpr double kTick = 6.0;     // half the length of the line across an end, logical pixels
constexpr double kMark = 7.0;     // half of 14 px
constexpr double kBeside = 12.0;  // from the line to its label
constexpr double kMargin = 4.0;

/// The sign of a kind of point, around the origin: people know them from CAD programs.
QPainterPath markOf(SnapKind kind) {
    QPainterPath path;
    const auto polygon = [&path](std::initializer_list<QPointF> points) {
        path.addPolygon(QPolygonF(QList<QPointF>(points)));
        path.closeSubpath();
    };
    switch (kind) {
        case SnapKind::Centre: path.addEllipse(QPointF(), kMark, kMark); break;
        case SnapKind::End: path.addRect(-kMark, -kMark, 2 * kMark, 2 * kMark); break;
        case SnapKind::ArcCentre: polygon({{0, -kMark}, {kMark, 0}, {0, kMark}, {-kMark, 0}}); break;
        case SnapKind::Middle: polygon({{0, -kMark}, {kMark, kMark}, {-kMark, kMark}}); break;
        case SnapKind::Edge: polygon({{-kMark, -kMark}, {kMark, -kMark}, {-kMark, kMark}, {kMark, kMark}}); break;
        case SnapKind::Crossing:
        case SnapKind::Free: {
            const double arm = kind == SnapKind::Free ? 0.0 : kMark;
            path.moveTo(-kMark, -arm);
            path.lineTo(kMark, arm);
            path.moveTo(kind == SnapKind::Free ? 0.0 : -kMark, kMark);
            path.lineTo(kind == SnapKind::Free ? 0.0 : kMark, -kMark);
            break;
        }
    }
    return path;
}

}  // namespace

glm::vec3 drawnPlaceOf(const BoardView& view, BoardPlace place, const model::Document& document,
                       const MeasuredEnd& end) {
    const std::vector<render::ZRange> heights = view.drawnHeights();
    const model::LayerId layer = document.findLayer(end.layer);
    const bool isFromAbove = view.controller().camera().direction().z < 0.0F;
    const double board = isFromAbove ? document.boardThickness : 0.0;
    glm::vec3 at = place.toModel({end.x, end.y}, board);
    if (layer.isValid() && layer.row() < heights.size()) {
        at.z = isFromAbove ? heights[layer.row()].z1 : heights[layer.row()].z0;
    }
    return at;
}

MeasurementPainter::MeasurementPainter(QPainter& painter, const BoardView& view, BoardPlace place,
                                       const model::Document& document)
    : m_painter(painter), m_view(view), m_place(place), m_document(document) {}

std::optional<QPointF> MeasurementPainter::screenOf(const MeasuredEnd& end) const {
    return m_view.controller().screenOf(drawnPlaceOf(m_view, m_place, m_document, end));
}

void MeasurementPainter::paint(const Measurement& measurement, models::LengthUnit unit, bool isFull) const {
    const std::optional<QPointF> from = screenOf(measurement.from);
    const std::optional<QPointF> to = screenOf(measurement.to);
    if (!from || !to) {
        return;
    }
    paintLine(*from, *to);
    QStringList lines{models::valueText(measurement)};
    if (!measurement.name.empty()) {
        lines.front().prepend(QString::fromStdString(measurement.name) + QStringLiteral(":  "));
    }
    if (isFull) {
        lines += models::partsText(measurement, unit);
        lines += models::layersText(measurement);
        lines += models::netsText(measurement);
    }
    paintLabel(lines, (*from + *to) / 2.0);
}

void MeasurementPainter::paintLine(QPointF from, QPointF to) const {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    const QPointF across = length > 0 ? QPointF(-way.y(), way.x()) * (kTick / length) : QPointF(0, kTick);
    for (const auto& [colour, width] : {std::pair(kUnderColour, 4.0), std::pair(kLineColour, 1.6)}) {
        m_painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        m_painter.drawLine(from, to);
        for (const QPointF end : {from, to}) {
            m_painter.drawLine(end - across, end + across);
        }
    }
}

void MeasurementPainter::paintLabel(const QStringList& lines, QPointF beside) const {
    const QFontMetricsF metrics(m_painter.font());
    double width = 0.0;
    for (const QString& line : lines) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    const QSizeF size(width + 2 * kMargin, metrics.height() * static_cast<double>(lines.size()) + 2 * kMargin);
    QRectF box(beside + QPointF(kBeside, kBeside), size);
    // Inside of the canvas as long as there is room.
    const QSizeF canvas = m_view.controller().viewport();
    box.moveLeft(std::max(0.0, std::min(box.left(), canvas.width() - box.width())));
    box.moveTop(std::max(0.0, std::min(box.top(), canvas.height() - box.height())));
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(kLabelColour);
    m_painter.drawRoundedRect(box, 3.0, 3.0);
    QPointF at = box.topLeft() + QPointF(kMargin, kMargin + metrics.ascent());
    m_painter.setPen(kLineColour);
    for (const QString& line : lines) {
        m_painter.drawText(at, line);
        m_painter.setPen(Qt::white);
        at.ry() += metrics.height();
    }
}

void MeasurementPainter::paintSnap(const MeasuredEnd& end, SnapKind kind) const {
    const std::optional<QPointF> at = screenOf(end);
    if (!at) {
        return;
    }
    const QPainterPath mark = markOf(kind).translated(*at);
    m_painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(kUnderColour, 4.0), std::pair(QColor(Qt::white), 1.6)}) {
        m_painter.setPen(QPen(colour, width));
        m_painter.drawPath(mark);
    }
    paintLabel({QLatin1String(toString(kind))}, *at);
}

}  // namespace ui
