// What is drawn around a cross-section: bends and layers of its line, dimensions, the legend.

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/section/section_view.h"

namespace ui {

namespace {

using model::SectionPiece;

constexpr double kBendPixels = 5.0;
/// Bends closer together than this have a mark and no line.
constexpr double kRoomOfBend = 24.0;
constexpr double kSwatch = 9.0;
constexpr QColor kStale(150, 90, 0);

QColor readableOn(const QColor& ground) {
    return ground.lightnessF() > 0.55F ? QColor(Qt::black) : QColor(Qt::white);
}

void paintArrow(QPainter& painter, QPointF tip, QPointF from) {
    const QLineF line(tip, from);
    if (line.length() < 12.0) {
        painter.drawEllipse(tip, 2.0, 2.0);
        return;
    }
    const QPointF ahead = (from - tip) / line.length();
    const QPointF across(-ahead.y(), ahead.x());
    painter.drawPolygon(QPolygonF{tip, tip + 7.0 * ahead + 2.5 * across, tip + 7.0 * ahead - 2.5 * across});
}

}  // namespace

/// A mark at the upper rim; where there is room a line down too.
void SectionView::paintBends(QPainter& painter) const {
    const std::vector<double> bends = model::bendsOf(*m_section);
    QColor ink = palette().color(QPalette::Text);
    double last = -1e9;
    for (std::size_t i = 0; i < bends.size(); ++i) {
        const double x = positionOf(bends[i], 0.0).x();
        const double next = i + 1 < bends.size() ? positionOf(bends[i + 1], 0.0).x() : 1e9;
        const bool hasRoom = x - last >= kRoomOfBend && next - x >= kRoomOfBend;
        ink.setAlpha(110);
        painter.setPen(QPen(ink, 0.7, Qt::DashLine));
        if (hasRoom) {
            painter.drawLine(QPointF(x, plot().top()), QPointF(x, plot().bottom()));
        }
        ink.setAlpha(255);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawPolygon(QPolygonF{QPointF(x, plot().top() + kBendPixels),
                                      QPointF(x - kBendPixels / 2, plot().top()),
                                      QPointF(x + kBendPixels / 2, plot().top())});
        last = x;
    }
}

/// On which layer the net runs, in the layer's colour; the changes between are vias.
void SectionView::paintRuns(QPainter& painter) const {
    const QRectF area = plot();
    for (const model::LayerRun& run : m_runs) {
        const double left = std::max(positionOf(run.from, 0.0).x(), area.left());
        const double right = std::min(positionOf(run.to, 0.0).x(), area.right());
        if (right <= left || run.layer.row() >= board().layers.size()) {
            continue;
        }
        const QRectF band(left, area.top() - lineHeight() - 2.0, right - left, lineHeight());
        const QColor colour = run.layer.row() < m_colours.size() ? m_colours[run.layer.row()] : QColor(Qt::gray);
        painter.setPen(QPen(palette().color(QPalette::Base), 1.0));
        painter.setBrush(colour);
        painter.drawRect(band);
        const QString name = QString::fromStdString(board().layer(run.layer).name);
        if (fontMetrics().horizontalAdvance(name) + 4.0 <= band.width()) {
            painter.setPen(readableOn(colour));
            painter.drawText(band, Qt::AlignCenter, name);
        }
    }
}

void SectionView::paintDimensions(QPainter& painter) const {
    std::vector<QRectF> taken;
    for (const model::SectionDimension& dimension : m_dimensions.all()) {
        paintDimension(painter, dimension, taken);
    }
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.setBrush(Qt::NoBrush);
    for (const auto& position : {m_dimensions.from(), m_under}) {
        if (position) {
            painter.drawEllipse(positionOf(position->along, position->z), 4.0, 4.0);
        }
    }
    if (m_dimensions.from() && m_under) {
        paintDimension(painter, {*m_dimensions.from(), *m_under}, taken);
    }
}

bool SectionView::isShownStale(const model::SectionDimension& dimension) const {
    return isStale(dimension) && dimension.to.isOnUpright + dimension.to.isOnLevel > 0;
}

QString SectionView::textOf(const model::SectionDimension& dimension) const {
    return dimensionText(dimension, m_unit) + (isShownStale(dimension) ? tr(", no longer on an edge") : QString());
}

/// With a label at its middle, below those that are there already.
void SectionView::paintDimension(QPainter& painter, const model::SectionDimension& dimension,
                                 std::vector<QRectF>& taken) const {
    const bool isStale = isShownStale(dimension);
    const QColor ink = isStale ? kStale : palette().color(QPalette::Text);
    const auto ends = dimension.ends();
    const QPointF from = positionOf(ends.first.along, ends.first.z);
    const QPointF to = positionOf(ends.second.along, ends.second.z);
    painter.setPen(QPen(palette().color(QPalette::Base), 4.0));
    painter.drawLine(from, to);
    painter.setPen(QPen(ink, 1.5, isStale ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(from, to);
    painter.setPen(QPen(ink, 1.0));
    painter.setBrush(ink);
    paintArrow(painter, from, to);
    paintArrow(painter, to, from);
    const QString text = textOf(dimension);
    QRectF box = QRectF(fontMetrics().boundingRect(text)).adjusted(-5, -2, 5, 2);
    const QPointF beside = dimension.isUpright() ? QPointF(box.width() / 2 + 6.0, 0.0) : QPointF(0.0, lineHeight());
    box.moveCenter((from + to) / 2.0 + beside);
    box.moveLeft(std::clamp(box.left(), plot().left(), std::max(plot().left(), plot().right() - box.width())));
    box.moveTop(std::clamp(box.top(), plot().top(), std::max(plot().top(), plot().bottom() - box.height())));
    const auto isTaken = [&] {
        return std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(box); });
    };
    const double first = box.top();
    while (isTaken() && box.bottom() + lineHeight() <= plot().bottom()) {
        box.translate(0.0, lineHeight());
    }
    if (isTaken()) {
        box.moveTop(first);
        while (isTaken() && box.top() - lineHeight() >= plot().top()) {
            box.translate(0.0, -lineHeight());
        }
    }
    taken.push_back(box);
    painter.setPen(QPen(ink, 0.7));
    painter.setBrush(palette().base());
    painter.drawRoundedRect(box, 3, 3);
    painter.drawText(box, Qt::AlignCenter, text);
}

std::vector<std::uint32_t> SectionView::layerColours() const {
    std::vector<std::uint32_t> colours;
    for (const QColor& colour : m_colours) {
        colours.push_back(colour.rgb() & 0xffffffU);
    }
    return colours;
}

std::vector<SectionView::LegendRow> SectionView::legend() const {
    std::vector<LegendRow> rows;
    for (const model::SectionLegendRow& row : model::legendOf(m_drawn, layerColours())) {
        std::vector<QColor> colours;
        for (const std::uint32_t colour : row.colours) {
            colours.push_back(QColor::fromRgb(colour));
        }
        rows.emplace_back(std::move(colours), tr(model::toString(row.material)));
    }
    return rows;
}

/// In one line over the whole width; what there is no room for is left out from the end.
void SectionView::paintLegend(QPainter& painter) const {
    double x = plot().left();
    const double y = height() - lineHeight();
    for (const auto& [colours, name] : legend()) {
        const double swatch = std::max<double>(kSwatch, 4.0 * static_cast<double>(colours.size()));
        const double wide = swatch + 4.0 + fontMetrics().horizontalAdvance(name) + 12.0;
        if (x + wide > width()) {
            return;
        }
        const QRectF box(x, y + (lineHeight() - kSwatch) / 2, swatch, kSwatch);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const double part = swatch / static_cast<double>(colours.size());
            painter.fillRect(QRectF(x + part * static_cast<double>(i), box.top(), part, kSwatch), colours[i]);
        }
        painter.setPen(QPen(palette().color(QPalette::Mid), 0.7));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(box);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x + swatch + 4.0, y + fontMetrics().ascent()), name);
        x += wide;
    }
}

}  // namespace ui
