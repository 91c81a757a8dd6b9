// How a cross-section is drawn.

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "model/export/stackup_drawing.h"
#include "render/scene/element_state.h"
#include "ui/common/thickness_text.h"
#include "ui/section/section_view.h"

namespace ui {

namespace {

using model::SectionPiece;

constexpr double kTickPixels = 90.0;  // between the numbers of the ruler, about
constexpr double kApart = 6.0;        // between the texts of a label
constexpr double kLeader = 34.0;      // the line that leads to a label
constexpr double kLeastName = 60.0;   // of a name beside figures

/// The next smaller of 1, 2, 5, 10, 20, …
double roundNumber(double value) {
    const double ten = std::pow(10.0, std::floor(std::log10(value)));
    return value >= 5 * ten ? 5 * ten : value >= 2 * ten ? 2 * ten : ten;
}

/// Of a thickness that is only assumed it slants.
QFont fontOf(QFont font, const model::StackupRow& row) {
    font.setItalic(row.source == model::Source::Assumed);
    return font;
}

}  // namespace

void SectionView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_section) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Choose Draw section above, then drag a line over the 2D view"));
        return;
    }
    painter.save();
    painter.setClipRect(plot());
    paintPieces(painter);
    paintBreaks(painter);
    paintHighlighted(painter);
    paintBends(painter);
    paintDimensions(painter);
    painter.restore();
    paintRuns(painter);
    paintLayers(painter);
    paintRuler(painter);
    paintLegend(painter);
}

/// Without smoothing: pieces lie side by side, and smoothed edges would let the ground through.
void SectionView::paintPieces(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    for (const SectionPiece& piece : m_drawn) {
        if (!rectOf(piece).intersects(plot())) {
            continue;
        }
        painter.setBrush(colourOf(piece));
        if (piece.leans()) {
            painter.drawPolygon(outlineOf(piece));
        } else {
            painter.fillRect(rectOf(piece), painter.brush());
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
}

/// A zigzag through each part near the rim beyond which it goes on.
void SectionView::paintBreaks(QPainter& painter) const {
    constexpr double kTooth = 4.0;
    painter.setPen(QPen(palette().color(QPalette::Base), 2.5));
    for (const QRectF& part : brokenParts()) {
        for (const bool isTop : {true, false}) {
            if (isTop ? part.top() >= plot().top() : part.bottom() <= plot().bottom()) {
                continue;
            }
            const double y = isTop ? plot().top() + 3.0 * kTooth : plot().bottom() - 3.0 * kTooth;
            QPolygonF line{QPointF(part.left(), y)};
            for (double x = part.left() + kTooth; x < part.right() + kTooth; x += kTooth) {
                line += QPointF(x, y + (line.size() % 2 == 0 ? kTooth : -kTooth));
            }
            painter.drawPolyline(line);
        }
    }
}

void SectionView::paintHighlighted(QPainter& painter) const {
    const glm::vec3& colour = render::kHighlightColours.front();  // as in the views
    QColor ink = QColor::fromRgbF(colour.r, colour.g, colour.b);
    painter.setPen(QPen(ink, 1.5));
    ink.setAlpha(110);
    painter.setBrush(ink);
    for (const SectionPiece& piece : m_section->pieces) {
        if (isHighlighted(piece) && rectOf(piece).intersects(plot())) {
            painter.drawPolygon(outlineOf(piece));
        }
    }
}

model::SectionWindow SectionView::window() const {
    const double half = plot().width() / 2 / m_perNm;
    const double high = plot().height() / 2 / m_perNm / m_times;
    return {m_along - half, m_along + half, m_z - high, m_z + high};
}

std::optional<QPointF> SectionView::markOf(std::size_t row) const {
    const std::optional<model::RowMark> mark = model::markOf(board(), m_drawn, row, window());
    return mark ? std::optional(positionOf(mark->along, mark->z)) : std::nullopt;
}

/// Rows of the stackup that are in sight, in its order, wherever each is seen: all that there is room to name, or else
/// the copper, or as much of it.
std::vector<SectionView::NamedRow> SectionView::namedRows() const {
    std::vector<NamedRow> rows;
    for (std::size_t i = 0; i < board().stackup.rows.size(); ++i) {
        const model::StackupRow& row = board().stackup.rows[i];
        const auto mark = model::markOf(board(), m_drawn, i, window());
        const double top = positionOf(0.0, double{1} * row.z + row.thickness).y();
        const double bottom = positionOf(0.0, row.z).y();
        if (mark) {
            rows.push_back({&row, mark, positionOf(0.0, mark->z).y()});
        } else if (bottom >= plot().top() && top <= plot().bottom()) {
            rows.push_back({&row, mark, (std::max(top, plot().top()) + std::min(bottom, plot().bottom())) / 2});
        }
    }
    const auto room = static_cast<std::size_t>(std::max(1.0, plot().height() / lineHeight()));
    if (rows.size() > room) {
        std::erase_if(rows, [this](const NamedRow& named) {
            return !named.row->layer.isValid() || !board().layer(named.row->layer).isCopper();
        });
    }
    const std::size_t every = (rows.size() + room - 1) / room;
    std::vector<NamedRow> named;
    for (std::size_t i = 0; i < rows.size(); i += every) {
        named.push_back(rows[i]);
    }
    return named;
}

QString SectionView::heightText(const NamedRow& named) const {
    return tr("at %1").arg(lengthText(double(named.mark ? named.mark->bottom : named.row->z), m_unit));
}

SectionView::LabelWidths SectionView::widthsOf(const std::vector<NamedRow>& rows) const {
    LabelWidths widths;
    for (const NamedRow& named : rows) {
        const QFontMetrics letters(fontOf(font(), *named.row));
        const auto widen = [](double& width, int text) { width = std::max(width, text + kApart); };
        // A pixel more: widths are rounded, and what is wider by less would be cut.
        widen(widths.name, fontMetrics().horizontalAdvance(QString::fromStdString(named.row->name)) + 1);
        widen(widths.thickness, letters.horizontalAdvance(thicknessText(named.row->thickness, m_unit)));
        widen(widths.height, fontMetrics().horizontalAdvance(heightText(named)));
    }
    return widths;
}

double SectionView::roomForLabels() const {
    std::vector<NamedRow> rows;
    for (const model::StackupRow& row : board().stackup.rows) {
        rows.push_back({&row, {}, 0.0});
    }
    const LabelWidths widths = widthsOf(rows);
    return kLeader + widths.name + widths.thickness + widths.height;
}

/// Whether names that have so much room can be read, and two that differ still do.
bool SectionView::areTold(const std::vector<NamedRow>& rows, double room) const {
    std::map<QString, std::string> told;
    for (const NamedRow& named : rows) {
        const auto [other, isNew] = told.emplace(nameIn(named, room), named.row->name);
        if (!isNew && other->second != named.row->name) {
            return false;
        }
    }
    return room >= kLeastName;
}

/// Names tell the rows apart: where there is no room for all, they stay, and figures are left out, whole.
SectionView::LabelColumns SectionView::labelColumns(const std::vector<NamedRow>& rows) const {
    LabelWidths widths = widthsOf(rows);
    const double left = plot().right() + kLeader;
    const double room = width() - left;
    for (double* figures : {&widths.height, &widths.thickness}) {
        const double rest = room - widths.thickness - widths.height;
        if (rest < widths.name && !areTold(rows, rest)) {
            *figures = 0.0;
        }
    }
    const double thickness = left + std::min(widths.name, room - widths.thickness - widths.height);
    const double height = thickness + widths.thickness;
    return {left, thickness, height, height + widths.height};
}

/// `room` includes what is left free behind a name.
QString SectionView::nameIn(const NamedRow& named, double room) const {
    return fontMetrics().elidedText(QString::fromStdString(named.row->name), Qt::ElideMiddle,
                                    static_cast<int>(std::lround(room - kApart)));
}

SectionView::LabelTexts SectionView::textsOf(const NamedRow& named, const LabelColumns& columns) const {
    const bool hasThickness = columns.height > columns.thickness;
    const bool hasHeight = columns.end > columns.height;
    return {nameIn(named, columns.thickness - columns.name),
            hasThickness ? thicknessText(named.row->thickness, m_unit) : QString(),
            hasHeight ? heightText(named) : QString()};
}

std::vector<SectionView::LabelTexts> SectionView::labels() const {
    const std::vector<NamedRow> rows = m_section ? namedRows() : std::vector<NamedRow>();
    const LabelColumns columns = labelColumns(rows);
    std::vector<LabelTexts> labels;
    std::ranges::transform(rows, std::back_inserter(labels),
                           [&](const NamedRow& named) { return textsOf(named, columns); });
    return labels;
}

/// Names, thicknesses, and how high above the bottom they lie. A line leads from the name to where the row ends.
void SectionView::paintLayers(QPainter& painter) const {
    const std::vector<NamedRow> rows = namedRows();
    const QRectF area = plot();
    model::StackupDrawing labels;
    for (const NamedRow& named : rows) {
        const double y = named.y - area.top();
        labels.bands.push_back({y, y, y});
    }
    labels.height = std::max(area.height(), lineHeight() * static_cast<double>(rows.size()));
    model::spreadLabels(lineHeight(), labels);
    const LabelColumns columns = labelColumns(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        paintLabel(painter, rows[i], area.top() + labels.bands[i].label, columns);
    }
}

void SectionView::paintLabel(QPainter& painter, const NamedRow& named, double y, const LabelColumns& columns) const {
    constexpr double kDot = 1.5;
    if (const auto& mark = named.mark) {
        const QPointF from(positionOf(mark->along, 0.0).x(), named.y);
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 0.7));
        painter.drawPolyline(
            QPolygonF{from, {plot().right() + 8.0, from.y()}, {columns.name - 9.0, y}, {columns.name - 3.0, y}});
        painter.setBrush(palette().color(QPalette::Text));
        painter.drawEllipse(from, kDot, kDot);
    }
    painter.setPen(palette().color(QPalette::Text));
    const auto write = [&](double from, double to, const QString& text) {
        painter.drawText(QRectF(from, y - lineHeight() / 2, to - from, lineHeight()), Qt::AlignVCenter, text);
    };
    const auto [name, thickness, height] = textsOf(named, columns);
    write(columns.name, columns.thickness, name);
    painter.setFont(fontOf(font(), *named.row));
    write(columns.thickness, columns.height, thickness);
    painter.setFont(font());
    write(columns.height, width(), height);
}

void SectionView::paintRuler(QPainter& painter) const {
    const QRectF area = plot();
    const double per = nmPer(m_unit);
    const double step = roundNumber(2.0 * kTickPixels / m_perNm / per) * per;
    const double first = std::max(0.0, std::ceil((m_along - area.width() / 2 / m_perNm) / step) * step);
    const double last = std::min(m_section->stations.back(), m_along + area.width() / 2 / m_perNm);
    painter.setPen(palette().color(QPalette::Text));
    const double y = area.bottom() + 3.0;
    painter.drawLine(QPointF(std::max(positionOf(0.0, 0.0).x(), area.left()), y),
                     QPointF(positionOf(last, 0.0).x(), y));
    for (int i = 0; first + i * step <= last; ++i) {
        const double x = positionOf(first + i * step, 0.0).x();
        painter.drawLine(QPointF(x, y), QPointF(x, y + 4.0));
        const QString text = lengthText(first + i * step, m_unit);
        const double wide = fontMetrics().horizontalAdvance(text);
        painter.drawText(QPointF(std::max(x - wide / 2, 1.0), y + 4.0 + fontMetrics().ascent()), text);
    }
}

}  // namespace ui
