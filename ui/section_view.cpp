#include "ui/section_view.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/section/section_export.h"
#include "model/session/length_text.h"
#include "model/stack_drawing.h"
#include "ui/camera_controller.h"

namespace ui {

namespace {

using model::LayerType;
using model::SectionPiece;

constexpr double kMargin = 8.0;
constexpr double kLabels = 0.28;      // of the width
constexpr double kFilled = 0.8;       // of the plot, by a cut that is shown whole
constexpr double kLeastPixels = 0.7;  // of a piece: none vanishes
constexpr double kReachPixels = 2.0;  // around a piece, for the mouse
constexpr double kTickPixels = 90.0;  // between the numbers of the ruler, about
constexpr double kWheelNotch = 120.0;
constexpr double kMostPerNm = 1e-2;  // 10 µm across a pixel times a thousand: nothing is smaller
constexpr double kLeastPerNm = 1e-8;

/// What others lie in or stand upon is drawn first.
int orderOf(const model::Layer& layer) {
    return layer.type == LayerType::Body || layer.type == LayerType::Dielectric ? 0
           : layer.type == LayerType::ComponentBody                             ? 1
                                                                                : 2;
}

/// The next smaller of 1, 2, 5, 10, 20, …
double roundNumber(double value) {
    const double ten = std::pow(10.0, std::floor(std::log10(value)));
    return value >= 5 * ten ? 5 * ten : value >= 2 * ten ? 2 * ten : ten;
}

}  // namespace

SectionView::SectionView(models::SelectionModel& selection, QWidget* parent) : QWidget(parent), m_selection(selection) {
    setAccessibleName(QStringLiteral("Cross-section"));
    setMinimumSize(200, 80);
    connect(&selection, &models::SelectionModel::highlightChanged, this, qOverload<>(&QWidget::update));
    connect(&selection, &models::SelectionModel::hoverChanged, this, qOverload<>(&QWidget::update));
}

void SectionView::setSection(std::shared_ptr<const model::BoardIndex> board, std::optional<model::Section> section) {
    m_board = std::move(board);
    m_section = std::move(section);
    m_drawn.clear();
    if (m_section) {
        m_drawn = model::merged(m_section->pieces);
        std::ranges::stable_sort(m_drawn, {},
                                 [this](const SectionPiece& p) { return orderOf(this->board().layer(p.layer)); });
    }
    place();
}

void SectionView::setColours(std::vector<QColor> colours) {
    m_colours = std::move(colours);
    update();
}

void SectionView::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    update();
}

void SectionView::setHeightTimes(double times) {
    m_wantedTimes = times;
    place();
}

void SectionView::fit() {
    m_isFitted = true;
    place();
}

QSize SectionView::sizeHint() const {
    return {600, 260};
}

double SectionView::lineHeight() const {
    return fontMetrics().height() + 1.0;
}

QRectF SectionView::plot() const {
    return {kMargin, kMargin, width() * (1.0 - kLabels) - kMargin, height() - kMargin - 2.0 * lineHeight()};
}

/// Lengths and heights to pixels: of the whole line unless the user has chosen a part of it.
void SectionView::place() {
    if (m_section && m_isFitted) {
        const double length = m_section->stations.back();
        const double thickness = std::max<double>(board().boardThickness, 1.0);
        m_perNm = plot().width() / length;
        m_along = length / 2;
        m_z = thickness / 2;
        m_times = std::max(1.0, std::floor(kFilled * plot().height() / (thickness * m_perNm)));
    }
    m_times = m_wantedTimes > 0.0 ? m_wantedTimes : m_times;
    update();
}

void SectionView::resizeEvent(QResizeEvent*) {
    place();
}

QPointF SectionView::positionOf(double along, double z) const {
    return plot().center() + QPointF((along - m_along) * m_perNm, (m_z - z) * m_perNm * m_times);
}

QRectF SectionView::rectOf(const SectionPiece& piece) const {
    QRectF rect(positionOf(piece.from, piece.top), positionOf(piece.to, piece.bottom));
    rect.setWidth(std::max(rect.width(), kLeastPixels));
    rect.setHeight(std::max(rect.height(), kLeastPixels));
    return rect;
}

/// Foils are thinner than a hand is steady: what is drawn within a few pixels counts, if nothing better lies there.
const SectionPiece* SectionView::pieceAt(QPointF at) const {
    if (!m_section || !plot().contains(at)) {
        return nullptr;
    }
    const auto standing = [&](const SectionPiece& piece) {
        const bool isThere = rectOf(piece).contains(at);
        return std::tuple(orderOf(board().layer(piece.layer)), isThere, piece.from - piece.to);
    };
    const SectionPiece* found = nullptr;
    for (const SectionPiece& piece : m_section->pieces) {
        const QRectF reach = rectOf(piece).adjusted(-kReachPixels, -kReachPixels, kReachPixels, kReachPixels);
        if (reach.contains(at) && (found == nullptr || standing(piece) > standing(*found))) {
            found = &piece;
        }
    }
    if (found != nullptr) {
        return found;
    }
    const auto bore =
        std::ranges::find_if(m_section->bores, [&](const SectionPiece& p) { return rectOf(p).contains(at); });
    return bore != m_section->bores.end() ? &*bore : nullptr;
}

QString SectionView::tipAt(QPointF at) const {
    const SectionPiece* piece = pieceAt(at);
    if (piece == nullptr) {
        return {};
    }
    const bool isBore = !m_section->bores.empty() && piece >= m_section->bores.data() &&
                        piece < m_section->bores.data() + m_section->bores.size();
    QString tip = QString::fromStdString(board().layer(piece->layer).name);
    tip += isBore ? QStringLiteral(", bored out") : QString();
    if (const std::string net = model::netOf(*m_board, *piece); !net.empty()) {
        tip += QStringLiteral(" · ") + QString::fromStdString(net);
    }
    return tip + QStringLiteral("\n%1 wide, %2 high, from %3 to %4 above the bottom")
                     .arg(models::lengthText(piece->to - piece->from, m_unit),
                          models::lengthText(piece->top - piece->bottom, m_unit),
                          models::lengthText(piece->bottom, m_unit), models::lengthText(piece->top, m_unit));
}

bool SectionView::isLit(const SectionPiece& piece) const {
    if (m_selection.hovered() == piece.at || std::ranges::binary_search(m_selection.selected(), piece.at)) {
        return true;
    }
    const std::optional<model::BoardNet> net = m_selection.nets().empty() ? std::nullopt : m_selection.netOf(piece.at);
    return net && std::ranges::binary_search(m_selection.nets(), *net);
}

void SectionView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_section) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         QStringLiteral("Draw a section (Board menu), then drag a line over the 2D view"));
        return;
    }
    painter.save();
    painter.setClipRect(plot());
    paintPieces(painter);
    paintLit(painter);
    paintCorners(painter);
    painter.restore();
    paintLayers(painter);
    paintRuler(painter);
}

void SectionView::paintPieces(QPainter& painter) const {
    for (const SectionPiece& piece : m_drawn) {
        const QRectF rect = rectOf(piece);
        if (rect.intersects(plot())) {
            painter.fillRect(rect,
                             piece.layer.row() < m_colours.size() ? m_colours[piece.layer.row()] : QColor(Qt::gray));
        }
    }
}

void SectionView::paintLit(QPainter& painter) const {
    QColor ink = palette().color(QPalette::Highlight);
    painter.setPen(QPen(ink, 1.5));
    ink.setAlpha(110);
    painter.setBrush(ink);
    for (const SectionPiece& piece : m_section->pieces) {
        if (isLit(piece) && rectOf(piece).intersects(plot())) {
            painter.drawRect(rectOf(piece));
        }
    }
}

/// Where the line turns.
void SectionView::paintCorners(QPainter& painter) const {
    painter.setPen(QPen(palette().color(QPalette::Text), 0.7, Qt::DashLine));
    for (std::size_t i = 1; i + 1 < m_section->stations.size(); ++i) {
        const double x = positionOf(m_section->stations[i], 0.0).x();
        painter.drawLine(QPointF(x, plot().top()), QPointF(x, plot().bottom()));
    }
}

/// Rows of the stack that are in sight: all that there is room to name, or else the copper, or as much of it.
std::vector<const model::StackRow*> SectionView::namedRows() const {
    std::vector<const model::StackRow*> rows;
    for (const model::StackRow& row : board().stackup.rows) {
        if (positionOf(0.0, row.z).y() >= plot().top() &&
            positionOf(0.0, double{1} * row.z + row.thickness).y() <= plot().bottom()) {
            rows.push_back(&row);
        }
    }
    const auto room = static_cast<std::size_t>(std::max(1.0, plot().height() / lineHeight()));
    if (rows.size() > room) {
        std::erase_if(rows, [this](const model::StackRow* row) {
            return !row->layer.isValid() || !board().layer(row->layer).isCopper();
        });
    }
    const std::size_t every = (rows.size() + room - 1) / room;
    std::vector<const model::StackRow*> named;
    for (std::size_t i = 0; i < rows.size(); i += every) {
        named.push_back(rows[i]);
    }
    return named;
}

/// Names and thicknesses.
void SectionView::paintLayers(QPainter& painter) const {
    const std::vector<const model::StackRow*> rows = namedRows();
    const QRectF area = plot();
    model::StackDrawing labels;
    for (const model::StackRow* row : rows) {
        const double top = std::max(positionOf(0.0, double{1} * row->z + row->thickness).y(), area.top());
        const double bottom = std::min(positionOf(0.0, row->z).y(), area.bottom());
        labels.bands.push_back({top - area.top(), bottom - area.top(), (top + bottom) / 2 - area.top()});
    }
    labels.height = std::max(area.height(), lineHeight() * static_cast<double>(rows.size()));
    model::spreadLabels(lineHeight(), labels);
    const double left = area.right() + 34.0;
    const double thicknessLeft = left + (width() - left) * 0.62;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const model::StackBand& band = labels.bands[i];
        const double middle = area.top() + (band.top + band.bottom) / 2;
        const double y = area.top() + band.label;
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 0.7));
        painter.drawPolyline(
            QPolygonF{{area.right() + 2.0, middle}, {area.right() + 8.0, middle}, {left - 9.0, y}, {left - 3.0, y}});
        painter.setPen(palette().color(QPalette::Text));
        const auto write = [&](double from, double to, const QString& text) {
            painter.drawText(QRectF(from, y - lineHeight() / 2, to - from, lineHeight()), Qt::AlignVCenter,
                             fontMetrics().elidedText(text, Qt::ElideMiddle, static_cast<int>(to - from)));
        };
        write(left, thicknessLeft - 6.0, QString::fromStdString(rows[i]->name));
        QFont slanted = font();
        slanted.setItalic(rows[i]->source == model::Source::Assumed);
        painter.setFont(slanted);
        write(thicknessLeft, width(), QString::fromStdString(model::session::thicknessText(rows[i]->thickness)));
        painter.setFont(font());
    }
}

void SectionView::paintRuler(QPainter& painter) const {
    const QRectF area = plot();
    const double per = models::nmPer(m_unit);
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
        const QString text = models::lengthText(first + i * step, m_unit);
        const double wide = fontMetrics().horizontalAdvance(text);
        painter.drawText(QPointF(std::max(x - wide / 2, 1.0), y + 4.0 + fontMetrics().ascent()), text);
    }
}

void SectionView::wheelEvent(QWheelEvent* event) {
    const double factor =
        std::pow(static_cast<double>(CameraController::kZoomPerNotch), event->angleDelta().y() / kWheelNotch);
    const double after = std::clamp(m_perNm * factor, kLeastPerNm, kMostPerNm);
    // What is under the cursor stays there.
    const QPointF from = event->position() - plot().center();
    m_along += from.x() / m_perNm - from.x() / after;
    m_z -= (from.y() / m_perNm - from.y() / after) / m_times;
    m_perNm = after;
    m_isFitted = false;
    event->accept();
    update();
}

void SectionView::mousePressEvent(QMouseEvent* event) {
    m_pressed = m_last = event->position();
    m_isDragged = false;
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
    m_isDragged = m_isDragged || QLineF(m_pressed, event->position()).length() >= CameraController::kClickPixels;
    if (!m_isDragged || event->buttons() == Qt::NoButton) {
        return;
    }
    const QPointF way = event->position() - m_last;
    m_last = event->position();
    m_along -= way.x() / m_perNm;
    m_z += way.y() / m_perNm / m_times;
    m_isFitted = false;
    update();
}

void SectionView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_isDragged || event->button() != Qt::LeftButton || !m_section) {
        return;
    }
    const SectionPiece* piece = pieceAt(event->position());
    m_selection.select(piece != nullptr ? std::vector{piece->at} : std::vector<model::BoardElement>{});
}

void SectionView::mouseDoubleClickEvent(QMouseEvent*) {
    fit();
}

bool SectionView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ui
