#include "ui/measure/measurement_painter.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/board/board_heights.h"
#include "ui/common/texts.h"
#include "ui/measure/measurement_model.h"

namespace ui {

using model::MeasuredEnd;
using model::MeasuredRun;
using model::Measurement;
using model::MeasurementKind;
using model::SnapKind;

namespace {

constexpr QColor kLineColour(255, 205, 70);
constexpr QColor kUnderColour(0, 0, 0, 200);
constexpr QColor kLabelColour(20, 22, 26, 215);
constexpr double kTick = 6.0;  // half the length of the line across an end, logical pixels
constexpr double kMark = 7.0;  // half of 14 px
constexpr double kMargin = 4.0;
constexpr double kLine = 1.6;
constexpr double kPathLine = 3.0;        // paths along copper
constexpr double kUnder = 2.4;           // what lies under a line is wider by
constexpr double kAngleArc = 46.0;       // the largest radius of the arc in an angle
constexpr double kLeaderFrom = 20.0;     // a label farther away than this has a leader
constexpr qsizetype kLabelLetters = 32;  // a line of a label has so many before it is broken
constexpr double kArcStep = std::numbers::pi / 36.0;

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

/// Adds a text in lines that leave most of a view free, as wide as what is there: between two ends, then between words.
void addInLines(const QString& text, QStringList& all) {
    qsizetype most = kLabelLetters;
    for (const QString& line : std::as_const(all)) {
        most = std::max(most, line.size());
    }
    if (text.size() <= most) {
        all += text;
        return;
    }
    QStringList lines{QString()};
    for (const QString& word : text.split(' ')) {
        const bool isFull = !lines.back().isEmpty() && lines.back().size() + 1 + word.size() > most;
        if (isFull || word == QStringLiteral("–")) {
            lines.append(word);
        } else {
            lines.back() += (lines.back().isEmpty() ? QString() : QStringLiteral(" ")) + word;
        }
    }
    all += lines;
}

}  // namespace

DrawnHeights::DrawnHeights(const BoardView& view, const model::Document& document)
    : m_position(view.position()),
      m_document(document),
      m_board(model::boardHeights(document)),
      m_heights(view.drawnHeights()),
      m_isFromAbove(view.controller().camera().direction().z < 0.0F) {}

glm::vec3 DrawnHeights::at(base::PointD nm, const std::string& layer) const {
    const model::LayerId id = m_document.findLayer(layer);
    glm::vec3 at = m_position.toModel(nm, static_cast<double>(m_isFromAbove ? m_board.top : m_board.bottom));
    if (id.isValid() && id.row() < m_heights.size()) {
        at.z = m_isFromAbove ? m_heights[id.row()].z1 : m_heights[id.row()].z0;
    }
    return at;
}

MeasurementPainter::MeasurementPainter(QPainter& painter, const BoardView& view, const model::Document& document)
    : m_painter(painter), m_view(view), m_heights(view, document), m_placing(view.controller().viewport()) {
    for (const QRectF& corner : view.corners()) {
        m_placing.keepFree(corner);
    }
}

std::optional<QPointF> MeasurementPainter::screenOf(base::PointD nm, const std::string& layer) const {
    return m_view.controller().screenOf(m_heights.at(nm, layer));
}

std::optional<QPointF> MeasurementPainter::screenOf(const MeasuredEnd& end) const {
    return m_view.controller().screenOf(m_heights.at(end));
}

void MeasurementPainter::paint(const Measurement& measurement, LengthUnit unit, bool isFull) {
    const std::optional<QPointF> beside = measurement.kind == MeasurementKind::Angle    ? paintAngle(measurement)
                                          : measurement.kind == MeasurementKind::Radius ? paintRadius(measurement)
                                          : measurement.kind == MeasurementKind::Length ? paintPath(measurement)
                                                                                        : paintDistance(measurement);
    if (!beside) {
        return;
    }
    QStringList lines{valueText(measurement, unit)};
    if (!measurement.name.empty()) {
        lines.front().prepend(QString::fromStdString(measurement.name) + QStringLiteral(":  "));
    }
    if (isFull) {
        lines += partsText(measurement, unit);
        if (!measurement.path) {
            lines += layersText(measurement);
        }
        addInLines(netsText(measurement), lines);
        for (const QString& note : textsOf(measurement.notes)) {
            addInLines(note, lines);
        }
    }
    m_labels.push_back({lines, *beside});
}

std::optional<QPointF> MeasurementPainter::paintDistance(const Measurement& measurement) {
    const std::optional<QPointF> from = screenOf(measurement.from);
    const std::optional<QPointF> to = screenOf(measurement.to);
    if (!from || !to) {
        return std::nullopt;
    }
    drawLine({*from, *to}, kLine);
    drawTick(*from, *to - *from);
    drawTick(*to, *to - *from);
    return middleWithin({*from, *to}, canvas());
}

std::optional<QPointF> MeasurementPainter::paintAngle(const Measurement& measurement) {
    const MeasuredEnd& corner = *measurement.corner;
    const std::optional<QPointF> apex = screenOf(corner);
    const std::optional<QPointF> from = screenOf({measurement.from.x, measurement.from.y}, corner.layer);
    const std::optional<QPointF> to = screenOf({measurement.to.x, measurement.to.y}, corner.layer);
    if (!apex || !from || !to) {
        return std::nullopt;
    }
    drawLine({*from, *apex, *to}, kLine);
    const base::PointD u = {measurement.from.x - corner.x, measurement.from.y - corner.y};
    const base::PointD v = {measurement.to.x - corner.x, measurement.to.y - corner.y};
    const double radius = std::min(
        {std::hypot(u.x, u.y) / 2.0, std::hypot(v.x, v.y) / 2.0, kAngleArc * m_view.controller().nmPerPixel()});
    const double sweep = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    const QPolygonF arc = arcAround({corner.x, corner.y}, corner.layer, radius, std::atan2(u.y, u.x), sweep);
    drawLine(arc, kLine);
    return middleWithin(arc, canvas());
}

std::optional<QPointF> MeasurementPainter::paintRadius(const Measurement& measurement) {
    const std::optional<QPointF> from = screenOf(measurement.from);
    const std::optional<QPointF> to = screenOf(measurement.to);
    if (!from || !to) {
        return std::nullopt;
    }
    const double radius = std::hypot(measurement.dx(), measurement.dy());
    drawLine(arcAround({measurement.from.x, measurement.from.y}, measurement.from.layer, radius, 0.0,
                       2.0 * std::numbers::pi),
             kLine, Qt::DashLine);
    drawLine({*from, *to}, kLine);
    drawTick(*to, *to - *from);
    m_painter.setBrush(kLineColour);
    m_painter.drawEllipse(*from, 2.0, 2.0);
    return canvas().contains(*to) ? to : middleWithin({*from, *to}, canvas());
}

std::optional<QPointF> MeasurementPainter::paintPath(const Measurement& measurement) {
    QPolygonF line;
    const auto add = [&](const std::optional<QPointF>& at) {
        // Locations that fall on one pixel are one.
        if (at && (line.isEmpty() || (*at - line.back()).manhattanLength() >= 1.0)) {
            line += *at;
        }
    };
    add(screenOf(measurement.from));
    for (const MeasuredRun& run : measurement.path->runs) {
        for (const base::PointD& corner : run.line) {
            add(screenOf(corner, run.layer));
        }
    }
    add(screenOf(measurement.to));
    if (line.size() == 1) {
        line += line.front();  // too small to be seen
    }
    if (line.isEmpty()) {
        return std::nullopt;
    }
    drawLine(line, kPathLine);
    drawTick(line.front(), line[1] - line[0]);
    drawTick(line.back(), line.back() - line[line.size() - 2]);
    return middleWithin(line, canvas());
}

QPolygonF MeasurementPainter::arcAround(base::PointD centre, const std::string& layer, double radius, double start,
                                        double sweep) const {
    QPolygonF arc;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kArcStep)));
    for (int part = 0; part <= parts; ++part) {
        const double angle = start + sweep * part / parts;
        if (const auto at =
                screenOf({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)}, layer)) {
            arc += *at;
        }
    }
    return arc;
}

void MeasurementPainter::drawLine(const QPolygonF& line, double width, Qt::PenStyle style) {
    const double beyond = width + kUnder;  // where ends are round
    const QList<QPolygonF> parts = partsWithin(line, canvas().adjusted(-beyond, -beyond, beyond, beyond));
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(kUnderColour, width + kUnder, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(kLineColour, width, style, Qt::RoundCap, Qt::RoundJoin)}) {
        m_painter.setPen(pen);
        for (const QPolygonF& part : parts) {
            m_painter.drawPolyline(part);
        }
    }
    for (const QPolygonF& part : parts) {
        for (qsizetype i = 0; i + 1 < part.size(); ++i) {
            m_placing.avoid({part[i], part[i + 1]});
        }
    }
}

void MeasurementPainter::drawTick(QPointF at, QPointF along) {
    const double length = std::hypot(along.x(), along.y());
    const QPointF across = length > 0 ? QPointF(-along.y(), along.x()) * (kTick / length) : QPointF(0, kTick);
    drawLine({at - across, at + across}, kLine);
}

void MeasurementPainter::paintSnap(const MeasuredEnd& end, SnapKind kind, const QString& word) {
    const std::optional<QPointF> at = screenOf(end);
    if (!at) {
        return;
    }
    const QPainterPath mark = markOf(kind).translated(*at);
    m_painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(kUnderColour, kLine + kUnder), std::pair(QColor(Qt::white), kLine)}) {
        m_painter.setPen(QPen(colour, width));
        m_painter.drawPath(mark);
    }
    const QRectF around = mark.boundingRect();
    m_placing.avoid({around.topLeft(), around.bottomRight()});
    m_placing.avoid({around.bottomLeft(), around.topRight()});
    if (!word.isEmpty()) {
        m_labels.push_back({{word}, *at});
    }
}

std::vector<QRectF> MeasurementPainter::paintLabels() {
    std::vector<QRectF> boxes;
    const QFontMetricsF metrics(m_painter.font());
    for (const Label& label : m_labels) {
        double width = 0.0;
        for (const QString& line : label.lines) {
            width = std::max(width, metrics.horizontalAdvance(line));
        }
        const double height = metrics.height() * static_cast<double>(label.lines.size());
        boxes.push_back(m_placing.place(label.beside, {width + 2 * kMargin, height + 2 * kMargin}));
        paintLabel(label, boxes.back());
    }
    return boxes;
}

void MeasurementPainter::paintLabel(const Label& label, const QRectF& box) const {
    const QPointF nearest(std::clamp(label.beside.x(), box.left(), box.right()),
                          std::clamp(label.beside.y(), box.top(), box.bottom()));
    if (QLineF(nearest, label.beside).length() > kLeaderFrom) {
        m_painter.setPen(QPen(kLineColour, 1.0, Qt::DotLine));
        m_painter.drawLine(label.beside, nearest);
    }
    const QFontMetricsF metrics(m_painter.font());
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(kLabelColour);
    m_painter.drawRoundedRect(box, 3.0, 3.0);
    QPointF at = box.topLeft() + QPointF(kMargin, kMargin + metrics.ascent());
    m_painter.setPen(kLineColour);
    for (const QString& line : label.lines) {
        m_painter.drawText(at, line);
        m_painter.setPen(Qt::white);
        at.ry() += metrics.height();
    }
}

}  // namespace ui
